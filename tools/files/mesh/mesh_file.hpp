// A mesh as it stands in a file: positions and topology of one frame.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

struct MeshFile {
  std::vector<Point> positions;  ///< finite where something uses them
  std::vector<Face> faces;       ///< in the file's order and winding; polygons are cut into triangles
  std::vector<Edge> loose_edges;
  std::vector<Index> loose_points;
  std::vector<std::string> notes;  ///< what a reader should know: polygons cut, elements skipped
  /// Of a file with polygons of more than three corners: the number of corners of each face, and all corners in turn.
  std::vector<Index> corner_counts = {}, corners = {};
  bool are_floats = false;        ///< coordinates are stored in single precision
  std::size_t surface_notes = 0;  ///< how many of the notes, the last ones, are about triangles and edges

  /// What to know about a later frame of a mesh: it has the triangles of the first.
  std::span<const std::string> notes_of_later_frame() const {
    return std::span(notes).first(notes.size() - surface_notes);
  }
};

/// Reads a file of any of the mesh_formats(). Every index is in range and there is at least one feature. Throws
/// FileError.
MeshFile read_mesh(const std::filesystem::path& path);
/// The same for the bytes of a file that is in memory already.
MeshFile mesh_in(std::string_view bytes, const std::filesystem::path& path);

/// The topology of the file.
Mesh mesh_of(MeshFile file);

/// Do both have as many vertices, and the same faces, loose edges and loose points? A face may begin at another of its
/// corners. Polygons are compared, not their triangles: which these are depends on positions, so frames of one mesh
/// share the triangles of the first.
bool has_topology_of(const MeshFile& first, const MeshFile& second);

/// Throws FileError, naming both files and the first difference, unless they have one topology (as
/// has_topology_of).
void require_same_mesh(const MeshFile& first, const std::string& first_name, const MeshFile& second,
                       const std::string& second_name);

}  // namespace tamis::io
