#include "files/mesh/coordinate_spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamis::io {
namespace {

/// Edges that are too short for their coordinates.
class CoarseEdges {
 public:
  explicit CoarseEdges(const MeshFile& mesh)
      : mesh_(mesh),
        relative_(mesh.are_floats ? double{std::numeric_limits<float>::epsilon()}
                                  : std::numeric_limits<double>::epsilon()) {}

  void add(Index a, Index b) {
    const Point &p = mesh_.positions[static_cast<std::size_t>(a)], &q = mesh_.positions[static_cast<std::size_t>(b)];
    double length = 0, largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      length = std::max(length, std::abs(p[axis] - q[axis]));
      largest = std::max({largest, std::abs(p[axis]), std::abs(q[axis])});
    }
    constexpr double kFine = 10;
    // Largest times epsilon is at least the spacing and below twice the spacing.
    if (length == 0 || length > kFine * relative_ * largest) return;
    const double spacing =
        largest < std::numeric_limits<double>::min() ? 0 : relative_ * std::exp2(std::ilogb(largest));
    if (length > kFine * spacing) return;
    ++count_;
    spacing_ = std::max(spacing_, spacing);
    shortest_ = std::min(shortest_, length);
  }

  std::string note() const {
    if (count_ == 0) return {};
    return fmt::format(
        "coordinates are coarser than edges: {} numbers are up to {:.2g} apart here; {} sides of triangles or loose "
        "edges are shorter than ten times that, the shortest {:.2g}. Move the mesh to the origin before it is stored, "
        "or store doubles",
        mesh_.are_floats ? "float32" : "float64", spacing_, count_, shortest_);
  }

 private:
  const MeshFile& mesh_;
  double relative_;
  std::size_t count_ = 0;
  double spacing_ = 0, shortest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::string note_on_spacing(const MeshFile& mesh) {
  CoarseEdges edges(mesh);
  for (const Face& f : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) edges.add(f[i], f[(i + 1) % 3]);
  for (const Edge& e : mesh.loose_edges) edges.add(e[0], e[1]);
  return edges.note();
}

}  // namespace tamis::io
