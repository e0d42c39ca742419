// Bodies and their motion, frame by frame, read from a file (docs/files-and-command.md, "Files of bodies").
#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "files/mesh/mesh_file.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::io {

struct BodiesFile {
  struct NamedMesh {
    std::string name;  ///< its key in the file, or the path of its own file
    MeshFile mesh;
  };
  struct Body {
    static constexpr std::size_t kNoMesh = static_cast<std::size_t>(-1);

    std::string name;
    std::size_t mesh = kNoMesh;       ///< its place among `meshes`; kNoMesh if the body deforms
    std::vector<Pose> poses;          ///< one: it stays; one a frame: it moves as a whole; none: it deforms
    bool turns_linearly = false;      ///< rotation vectors are linear in time; else the shorter turn
    std::vector<std::string> frames;  ///< paths of mesh files of a deforming body, one a frame
    bool moves() const { return poses.size() != 1; }
  };

  std::vector<NamedMesh> meshes;  ///< every mesh of a body, once
  std::vector<Body> bodies;
  std::vector<std::array<std::size_t, 2>> may_not_touch;  ///< places among `bodies`
  std::size_t frame_count = 0;                            ///< >= 2
};

/// Reads the file and the meshes of bodies that do not deform. Throws FileError, which names file and place.
BodiesFile read_bodies(const std::filesystem::path& path);

}  // namespace tamis::io
