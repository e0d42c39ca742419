// Swept 16-DOPs of every vertex, edge and triangle of a mesh.
#pragma once
#include <vector>

#include "paper/bounds/k_dop.hpp"
#include "paper/bounds/moving_points.hpp"

namespace tamis::lab {

struct FeatureBoxes {
  std::vector<Dop16> vertices, edges, faces;

  /// `padding`: Euclidean distance, in the scale of the points.
  void update(const Mesh& mesh, const MovingPoints& points, double padding);
  std::uint64_t memory_bytes() const {
    return (vertices.capacity() + edges.capacity() + faces.capacity()) * sizeof(Dop16);
  }
};

}  // namespace tamis::lab
