// The constraints of cloth: edges, hinges, and tethers for pulls that a few sweeps over the edges would not carry far
// enough.
#include <Eigen/Geometry>
#include <array>
#include <map>

#include "scenes/simulation/model.hpp"

namespace tamis::simulation {
namespace {

Vec area_of(const Face& f, const Points& x) {
  return 0.5 * (x.col(f[1]) - x.col(f[0])).cross(x.col(f[2]) - x.col(f[0]));
}

Index corner_opposite(const Edge& edge, const Face& face) {
  for (Index v : face)
    if (v != edge[0] && v != edge[1]) return v;
  return edge[0];
}

/// Finds the point of a flat sheet nearest to a place, if one is about an edge away.
class SheetIndex {
 public:
  SheetIndex(const Points& sheet, double cell) : sheet_(sheet), cell_(cell) {
    for (Index v = 0; v < static_cast<Index>(sheet.cols()); ++v) cells_[cell_of(sheet.col(v))].push_back(v);
  }

  Index nearest(const Vec& place) const {
    const auto found = cells_.find(cell_of(place));
    if (found == cells_.end()) return -1;
    Index best = found->second.front();
    for (Index v : found->second)
      if ((sheet_.col(v) - place).squaredNorm() < (sheet_.col(best) - place).squaredNorm()) best = v;
    return best;
  }

 private:
  std::array<long, 2> cell_of(const Vec& p) const { return {std::lround(p.x() / cell_), std::lround(p.y() / cell_)}; }

  const Points& sheet_;
  double cell_;
  std::map<std::array<long, 2>, std::vector<Index>> cells_;
};

}  // namespace

void Model::add_fabric(Index first, const Surface& sheet, const Fabric& fabric) {
  const Points rest = as_points(sheet.points);
  const Mesh mesh(static_cast<Index>(rest.cols()), sheet.faces);
  for (const Face& f : mesh.faces())
    for (Index v : f) add_mass(particles.inverse_mass[first + v], fabric.density * area_of(f, rest).norm() / 3);
  const auto edges = mesh.edges();
  for (Index e = 0; e < static_cast<Index>(edges.size()); ++e) {
    const auto [a, b] = edges[static_cast<std::size_t>(e)];
    distances.push_back({first + a, first + b, (rest.col(a) - rest.col(b)).norm(), 1 / fabric.stretch});
    const auto sides = mesh.faces_of_edge(e);
    if (fabric.bend == 0 || sides.size() != 2) continue;
    const Face left = mesh.faces()[static_cast<std::size_t>(sides[0])];
    const Face right = mesh.faces()[static_cast<std::size_t>(sides[1])];
    if (area_of(left, rest).dot(area_of(right, rest)) <= 0) continue;
    Bend bend = make_bend({a, b, corner_opposite({a, b}, left), corner_opposite({a, b}, right)}, rest, fabric.bend);
    for (Index& v : bend.vertices) v += first;
    bends.push_back(bend);
  }
}

/// In a sweep Gauss-Seidel carries a pull over about one edge; tethers carry it over 27 (long range attachments of Kim,
/// Chentanez, Mueller 2012, between cloth and cloth). In a flat convex sheet the straight line is the shortest way.
void Model::add_tethers(Index first, const Surface& sheet) {
  const Points rest = as_points(sheet.points);
  double area = 0;
  for (const Face& f : sheet.faces) area += area_of(f, rest).norm();
  const double edge = std::sqrt(2 * area / static_cast<double>(sheet.faces.size()));
  const SheetIndex index(rest, edge);
  for (const double reach : {27 * edge, 9 * edge, 3 * edge}) {
    for (Index v = 0; v < static_cast<Index>(rest.cols()); ++v) {
      for (const Vec& direction : {Vec(1, 0, 0), Vec(0, 1, 0), Vec(0.7, 0.7, 0), Vec(0.7, -0.7, 0)}) {
        const Index end = index.nearest(rest.col(v) + reach * direction);
        if (end >= 0) tethers.push_back({first + v, first + end, (rest.col(v) - rest.col(end)).norm(), 0, true});
      }
    }
  }
}

}  // namespace tamis::simulation
