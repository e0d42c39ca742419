#include "command/verbs/mesh_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "audit/doubts.hpp"
#include "files/mesh/loose_features.hpp"
#include "tamis/components.hpp"

namespace tamis::cli {
namespace {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

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
  const auto exact = cross(difference<Rational>(b, a), difference<Rational>(c, a));
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

Index third_vertex(const Face& face, const Edge& edge) {
  for (const Index v : face)
    if (v != edge[0] && v != edge[1]) return v;
  return edge[0];
}

/// Do the points c and d lie in one half of a plane that ends at the line through a and b? Doubles decide the clear
/// cases, as above.
bool are_on_one_side(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto base = difference<double>(b, a), to_c = difference<double>(c, a), to_d = difference<double>(d, a);
  const auto n = cross(base, to_c), m = cross(base, to_d), turn = cross(n, m);
  double size = 0, sine = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    size = std::max({size, std::abs(n[i]), std::abs(m[i])});
    sine = std::max(sine, std::abs(turn[i]));
  }
  double longest = 0;
  for (const auto& side : {base, to_c, to_d})
    for (const double x : side) longest = std::max(longest, std::abs(x));
  constexpr double kClear = 1e-12;
  const double area = longest * longest, cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
  if ((sine > kClear * size * area || cosine < -kClear * area * area) && std::isfinite(area * area)) return false;
  const auto exact_base = difference<Rational>(b, a);
  const auto exact_n = cross(exact_base, difference<Rational>(c, a));
  const auto exact_m = cross(exact_base, difference<Rational>(d, a));
  const auto exact_turn = cross(exact_n, exact_m);
  const Rational exact_cosine = exact_n[0] * exact_m[0] + exact_n[1] * exact_m[1] + exact_n[2] * exact_m[2];
  return exact_turn[0] == 0 && exact_turn[1] == 0 && exact_turn[2] == 0 && exact_cosine > 0;
}

/// Do two triangles at this edge lie on each other?
bool is_flat_fold(const Mesh& mesh, const std::vector<Point>& positions, Index edge) {
  const Edge& ends = mesh.edges()[static_cast<std::size_t>(edge)];
  const auto faces = mesh.faces_of_edge(edge);
  const auto third = [&](std::size_t i) {
    return third_vertex(mesh.faces()[static_cast<std::size_t>(faces[i])], ends);
  };
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Index c = third(i), d = third(j);
      if (c != d && are_on_one_side(at(positions, ends[0]), at(positions, ends[1]), at(positions, c), at(positions, d)))
        return true;
    }
  return false;
}

std::size_t count_not_finite(const std::vector<Point>& positions) {
  return static_cast<std::size_t>(std::ranges::count_if(
      positions, [](const Point& p) { return !std::ranges::all_of(p, [](double x) { return std::isfinite(x); }); }));
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
  facts.not_finite_vertices = count_not_finite(positions);
  facts.coincident_vertices = audit::coincident_vertices(mesh, positions);
  for (Index edge = 0; edge < static_cast<Index>(mesh.edges().size()); ++edge)
    facts.flat_folds += is_flat_fold(mesh, positions, edge);
  facts.duplicate_faces = count_duplicates(mesh.faces());
  facts.components = static_cast<std::size_t>(components_of(mesh).count);
  facts.box.add(mesh, positions);
  return facts;
}

std::string text_of(const io::Box& box) {
  constexpr int kFewest = 6, kMost = 17;
  // Three digits of the box's side at least, wherever the box stands.
  int digits = kFewest;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double side = box.highest[axis] - box.lowest[axis];
    const double farthest = std::max(std::abs(box.lowest[axis]), std::abs(box.highest[axis]));
    if (side > 0 && std::isfinite(side))
      digits = std::max(digits, std::min(kMost, static_cast<int>(std::ceil(std::log10(farthest / side))) + 3));
  }
  const auto corner = [digits](const Point& p) {
    return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", p[0], digits, p[1], digits, p[2], digits);
  };
  return fmt::format("{} to {}", corner(box.lowest), corner(box.highest));
}

}  // namespace tamis::cli
