#include "cli/verbs/mesh_facts.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "io/mesh/loose_features.hpp"
#include "tamis/components.hpp"

namespace tamis::cli {
namespace {

const Point& at(const std::vector<Point>& positions, Index vertex) {
  return positions[static_cast<std::size_t>(vertex)];
}

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b) {
  return {Number(a[1] * b[2] - a[2] * b[1]), Number(a[2] * b[0] - a[0] * b[2]), Number(a[0] * b[1] - a[1] * b[0])};
}

template <class Number>
std::array<Number, 3> difference(const Point& a, const Point& b) {
  return {Number(Number(a[0]) - b[0]), Number(Number(a[1]) - b[1]), Number(Number(a[2]) - b[2])};
}

/// Doubles decide the clear cases: their error is far below 1e-12 of the squared size. Fractions decide the rest.
bool has_no_area(const Point& a, const Point& b, const Point& c) {
  const auto e = difference<double>(b, a), f = difference<double>(c, a), n = cross(e, f);
  double size = 0, area = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    size = std::max({size, std::abs(e[i]), std::abs(f[i])});
    area = std::max(area, std::abs(n[i]));
  }
  constexpr double kClear = 1e-12;
  if (area > kClear * size * size && std::isfinite(area)) return false;
  const auto exact = cross(difference<mpq_class>(b, a), difference<mpq_class>(c, a));
  return exact[0] == 0 && exact[1] == 0 && exact[2] == 0;
}

void count_edges(const Mesh& mesh, MeshFacts& facts) {
  for (Index edge = 0; edge < static_cast<Index>(mesh.edges().size()); ++edge) {
    const std::size_t faces = mesh.faces_of_edge(edge).size();
    facts.rods += faces == 0;
    facts.boundary_edges += faces == 1;
    facts.non_manifold_edges += faces > 2;
  }
}

std::size_t count_duplicates(std::span<const Face> faces) {
  std::vector<Face> sorted(faces.begin(), faces.end());
  for (Face& face : sorted) std::sort(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - std::unique(sorted.begin(), sorted.end()));
}

}  // namespace

MeshFacts facts_of(const Mesh& mesh, const std::vector<Point>& positions) {
  MeshFacts facts;
  count_edges(mesh, facts);
  facts.loose_points = io::loose_points_of(mesh).size();
  facts.unused_vertices = static_cast<std::size_t>(mesh.vertex_count()) - mesh.points().size();
  for (const Face& f : mesh.faces())
    facts.degenerate_faces += has_no_area(at(positions, f[0]), at(positions, f[1]), at(positions, f[2]));
  facts.duplicate_faces = count_duplicates(mesh.faces());
  facts.components = static_cast<std::size_t>(components_of(mesh).count);
  facts.box.add(mesh, positions);
  return facts;
}

}  // namespace tamis::cli
