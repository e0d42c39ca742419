// A mesh as it stands in a file: positions and topology of one frame.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

struct MeshFile {
  std::vector<Point> positions;  ///< finite
  std::vector<Face> faces;       ///< in the file's order and winding; polygons are cut into fans
  std::vector<Edge> loose_edges;
  std::vector<Index> loose_points;
  std::vector<std::string> notes;  ///< what a reader should know: polygons cut, elements skipped
};

/// Reads a file of any of the mesh_formats(). Every index is in range and there is at least one feature. Throws
/// FileError.
MeshFile read_mesh(const std::filesystem::path& path);

/// Notes a last line without a line end: the text may have been cut inside its last number, and nothing else shows it.
void note_open_end(std::string_view text, MeshFile& mesh);

/// The topology of the file.
Mesh mesh_of(MeshFile file);

/// Do both have the same faces, loose edges and loose points?
bool has_topology_of(const MeshFile& first, const MeshFile& second);

/// Throws FileError, naming both files and the first difference, unless they have one topology.
void require_same_mesh(const MeshFile& first, const std::string& first_name, const MeshFile& second,
                       const std::string& second_name);

}  // namespace tamis::io
