// The frames of a recorded motion, from the files that a user names.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "audit/frame_source.hpp"

namespace tamis::io {

/// What moves, where the caller knows it already.
struct GivenMesh {
  std::shared_ptr<const audit::AuditedMesh> mesh = nullptr;  ///< for a point cache; null: from a mesh file
  audit::Objects objects = {};  ///< if `mesh` is null: the objects of the mesh that is read
};

/// The files that stand for a motion, in order.
struct MotionFiles {
  std::vector<std::filesystem::path> meshes;
  std::filesystem::path cache;  ///< a point cache for the one mesh; empty: each mesh is a frame

  std::vector<std::filesystem::path> all() const;
};

/// Files, folders and patterns, in natural order (moving_files); a point cache (.pc2, .mdd) comes with one mesh file,
/// or with none if the caller has the mesh. Throws FileError.
MotionFiles motion_files(const std::vector<std::string>& names);

/// `given.mesh` takes the place of the mesh file. Throws FileError if a point cache comes with neither, if the first
/// frame cannot be used, or if the cache is not of this mesh. A later frame that cannot be used comes with a `problem`.
std::unique_ptr<audit::FrameSource> open_motion(const MotionFiles& files, GivenMesh given = {});

}  // namespace tamis::io
