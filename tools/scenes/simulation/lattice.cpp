#include "scenes/simulation/lattice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace tamis::simulation {
namespace {

using Cell = std::array<Index, 3>;

/// The lattice's place in space.
struct Frame {
  Vec origin;
  double size;  ///< of a cell, metres

  Vec local(const Vec& p) const { return (p - origin) / size; }
  Cell cell_of(const Vec& p) const {
    const Vec q = local(p);
    return {static_cast<Index>(std::floor(q[0])), static_cast<Index>(std::floor(q[1])),
            static_cast<Index>(std::floor(q[2]))};
  }
  Vec centre(const Cell& c) const { return origin + size * Vec(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5); }
};

/// Half a cell of room on every side, so that no point lies on the lattice's own surface.
Frame frame_around(const Surface& surface, Index cells, Cell& counts) {
  Eigen::AlignedBox3d bounds;
  for (const Vec& p : surface.points) bounds.extend(p);
  const double size = bounds.sizes().maxCoeff() / cells;
  for (int axis = 0; axis < 3; ++axis)
    counts[static_cast<std::size_t>(axis)] = static_cast<Index>(std::ceil(bounds.sizes()[axis] / size)) + 1;
  return {bounds.min() - Vec::Constant(size / 2), size};
}

/// The cells that hold a corner or the centre of a face, or whose own centre is inside.
std::set<Cell> occupied_cells(const Surface& surface, const Frame& frame, const Cell& counts) {
  std::set<Cell> cells;
  for (const Vec& p : surface.points) cells.insert(frame.cell_of(p));
  for (const Face& f : surface.faces) {
    Vec centre = Vec::Zero();
    for (Index v : f) centre += surface.points[static_cast<std::size_t>(v)] / 3;
    cells.insert(frame.cell_of(centre));
  }
  for (Index i = 0; i < counts[0]; ++i)
    for (Index j = 0; j < counts[1]; ++j)
      for (Index k = 0; k < counts[2]; ++k)
        if (winding_number(surface, frame.centre({i, j, k})) > 0.5) cells.insert({i, j, k});
  return cells;
}

/// Kuhn's six tetrahedra: paths from corner (0,0,0) to (1,1,1), one axis at a time; they match across cells.
constexpr std::array<std::array<std::size_t, 3>, 6> kAxisOrders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// The Kuhn tetrahedron of a point is given by the order of its coordinates within the cell.
Index order_of(const Vec& within) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return within[static_cast<int>(a)] > within[static_cast<int>(b)];
  });
  return static_cast<Index>(std::find(kAxisOrders.begin(), kAxisOrders.end(), axes) - kAxisOrders.begin());
}

}  // namespace

double winding_number(const Surface& surface, const Vec& point) {
  double angle = 0;  // half the solid angle: van Oosterom and Strackee 1983
  for (const Face& f : surface.faces) {
    const Vec a = surface.points[static_cast<std::size_t>(f[0])] - point;
    const Vec b = surface.points[static_cast<std::size_t>(f[1])] - point;
    const Vec c = surface.points[static_cast<std::size_t>(f[2])] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (2 * std::numbers::pi);
}

Lattice make_lattice(const Surface& surface, Index cells) {
  Cell counts;
  const Frame frame = frame_around(surface, cells, counts);
  Lattice lattice;
  std::map<Cell, Index> node_at, first_tetrahedron_of;
  const auto node = [&](const Cell& corner) {
    const auto [place, is_new] = node_at.try_emplace(corner, static_cast<Index>(lattice.nodes.size()));
    if (is_new) lattice.nodes.push_back(frame.origin + frame.size * Vec(corner[0], corner[1], corner[2]));
    return place->second;
  };
  for (const Cell& cell : occupied_cells(surface, frame, counts)) {
    first_tetrahedron_of[cell] = static_cast<Index>(lattice.tetrahedra.size());
    for (const auto& axes : kAxisOrders) {
      Cell corner = cell;
      std::array<Index, 4> corners{node(corner)};
      for (std::size_t i = 0; i < 3; ++i) {
        ++corner[axes[i]];
        corners[i + 1] = node(corner);
      }
      lattice.tetrahedra.push_back(corners);
    }
  }
  for (const Vec& p : surface.points) {
    const Cell cell = frame.cell_of(p);
    const Vec within = frame.local(p) - Vec(cell[0], cell[1], cell[2]);
    lattice.tetrahedron_of_point.push_back(first_tetrahedron_of.at(cell) + order_of(within));
  }
  return lattice;
}

}  // namespace tamis::simulation
