// A moving mesh made by a program: topology, and where each vertex is at the two ends of a step.
#pragma once
#include <string>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::scenes {

struct Scene {
  std::string name;
  std::vector<Point> start;  ///< positions at t=0
  std::vector<Point> end;    ///< positions at t=1
  std::vector<Face> faces;
  std::vector<Edge> loose_edges;
  std::vector<Index> loose_points;
  std::vector<Index> group_of_vertex;  ///< the object each vertex belongs to, counted from 0

  /// The new vertex's index.
  Index add_vertex(const Point& at_start, const Point& at_end, Index group);
  Index vertex_count() const { return static_cast<Index>(start.size()); }

  Mesh mesh() const { return Mesh(vertex_count(), faces, loose_edges, loose_points); }
  /// A view: the scene must outlive it.
  Step step() const { return {start, end}; }
};

}  // namespace tamis::scenes
