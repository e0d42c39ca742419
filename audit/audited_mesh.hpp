// A mesh with what a report says of its parts: the object of each vertex, and how far apart two features are on it.
#pragma once
#include <string>
#include <vector>

#include "tamis/mesh.hpp"

namespace tamis::audit {

/// Which vertices make an object.
struct Objects {
  /// One number a vertex of the mesh, from 0; -1 for none. Empty: the connected components, in the order of their first
  /// vertices.
  std::vector<Index> of_vertex = {};
  /// Name of each object; empty, or too short: objects are called by their numbers.
  std::vector<std::string> names = {};

  std::string name_of(Index object) const;
};

/// Made once a topology; frames that have it share it.
class AuditedMesh {
 public:
  /// Throws InvalidMesh unless `objects` has no number, or one for each vertex, from -1 on.
  explicit AuditedMesh(Mesh mesh, Objects objects = {});

  const Mesh& mesh() const { return mesh_; }
  const Objects& objects() const { return objects_; }
  Index object_of(Index vertex) const { return objects_.of_vertex[static_cast<std::size_t>(vertex)]; }
  /// Does a path of edges lead from one to the other?
  bool are_connected(Index a, Index b) const {
    return component_of_vertex_[static_cast<std::size_t>(a)] == component_of_vertex_[static_cast<std::size_t>(b)];
  }
  /// The vertices that an edge joins to each.
  const IndexRows& neighbours() const { return neighbours_; }

 private:
  Mesh mesh_;
  Objects objects_;
  std::vector<Index> component_of_vertex_;
  IndexRows neighbours_;
};

}  // namespace tamis::audit
