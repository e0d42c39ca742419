// A mesh with data for a report: the object of each vertex, and its neighbours along edges.
#pragma once
#include <string>
#include <vector>

#include "tamis/components.hpp"

namespace tamis::audit {

/// Which vertices make an object.
struct Objects {
  /// One number a vertex of the mesh, from 0; -1 for none. Empty: the connected components, in the order of their first
  /// vertices.
  std::vector<Index> of_vertex = {};
  /// Name of each object. If there are fewer, the others are called by their numbers.
  std::vector<std::string> names = {};

  std::string name_of(Index object) const;
};

/// Made once for each topology; the frames of a topology share it.
class AuditedMesh {
 public:
  /// Throws InvalidMesh unless `objects` has no numbers, or one >= -1 for each vertex.
  explicit AuditedMesh(Mesh mesh, Objects objects = {});

  const Mesh& mesh() const { return mesh_; }
  const Objects& objects() const { return objects_; }
  Index object_of(Index vertex) const { return objects_.of_vertex[static_cast<std::size_t>(vertex)]; }
  /// Does a path of edges lead from one vertex to the other?
  bool are_connected(Index a, Index b) const {
    const auto component = [&](Index v) { return components_.of_vertex[static_cast<std::size_t>(v)]; };
    return component(a) == component(b);
  }
  const Components& components() const { return components_; }
  /// For each vertex, the vertices that an edge joins to it.
  const std::vector<std::vector<Index>>& neighbours() const { return neighbours_; }

 private:
  Mesh mesh_;
  Objects objects_;
  Components components_;
  std::vector<std::vector<Index>> neighbours_;
};

}  // namespace tamis::audit
