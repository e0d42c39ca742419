#include "support/pair_cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scenes/point_math.hpp"

namespace tamis::test {
namespace {

using oracle::Motion;
using scenes::operator+, scenes::operator-, scenes::operator*;

Motion random_motion(PairKind, Random& random) {
  Motion m;
  for (Point& p : m.start) p = random.point_between(-1, 1);
  for (std::size_t i = 0; i < 4; ++i) m.end[i] = m.start[i] + random.point_between(-1, 1);
  return m;
}

Motion separated(PairKind kind, Random& random) {
  Motion m = random_motion(kind, random);
  const Point away = {random.coin() ? 4.0 : 0.5, random.between(-4, 4), random.coin() ? 4.0 : 0.0};
  for (std::size_t i = kind == PairKind::edge_edge ? 2 : 1; i < 4; ++i) {
    m.start[i] = m.start[i] + away;
    m.end[i] = m.end[i] + away;
  }
  return m;
}

/// A multiple of 1/8 in [0,1]; half of them are 0 or 1.
double dyadic_parameter(Random& random) {
  const Index choice = random.below(4);
  return choice == 0 ? 0 : choice == 1 ? 1 : (1 + random.below(7)) * 0.125;
}

/// The position of a vertex at time t. Exact for coordinates of few bits if t is a multiple of 1/8.
Point at(const Motion& m, std::size_t i, double t) { return (1 - t) * m.start[i] + t * m.end[i]; }

Motion exact_contact(PairKind kind, Random& random) {
  const double unit = random.coin() ? 0x1p-20 : 0x1p-4;
  const Index steps = static_cast<Index>(1 / unit);
  Motion m;
  for (std::size_t i = 0; i < 4; ++i) {
    m.start[i] = random.point_on_lattice(steps, unit);
    m.end[i] = m.start[i] + random.point_on_lattice(steps, unit);
  }
  const double t = dyadic_parameter(random), u = dyadic_parameter(random);
  const double v = (kind == PairKind::vertex_face ? 1 - u : 1) * dyadic_parameter(random);
  // Shifts the first feature with its motion so that vertex 0, or the point v on its edge, meets the other feature at
  // time t.
  const std::size_t moved = kind == PairKind::edge_edge ? 1 : 0;
  Point target = (1 - u) * at(m, 2, t) + u * at(m, 3, t);
  Point own = at(m, 0, t);
  if (kind == PairKind::vertex_face) target = (1 - u - v) * at(m, 1, t) + u * at(m, 2, t) + v * at(m, 3, t);
  if (kind == PairKind::edge_edge) own = (1 - v) * at(m, 0, t) + v * at(m, 1, t);
  if (kind == PairKind::vertex_edge) target = (1 - u) * at(m, 1, t) + u * at(m, 2, t);
  if (kind == PairKind::vertex_vertex) target = at(m, 1, t);
  for (std::size_t i = 0; i <= moved; ++i) {
    m.start[i] = m.start[i] + (target - own);
    m.end[i] = m.end[i] + (target - own);
  }
  return m;
}

Motion near_contact(PairKind kind, Random& random) {
  Motion m = exact_contact(kind, random);
  const double size = std::ldexp(std::numeric_limits<double>::epsilon(), random.below(12));
  for (auto* points : {&m.start, &m.end})
    for (Point& p : *points) p = p + random.point_between(-size, size);
  return m;
}

/// Moves one coordinate to the next double.
void nudge(Motion& m, Random& random) {
  Point& p = (random.coin() ? m.start : m.end)[static_cast<std::size_t>(random.below(4))];
  double& x = p[static_cast<std::size_t>(random.below(3))];
  x = std::nextafter(x, random.coin() ? 2.0 : -2.0);
}

Motion nudged(PairKind kind, Random& random) {
  Motion m = exact_contact(kind, random);
  nudge(m, random);
  return m;
}

Motion uneven(PairKind kind, Random& random) {
  Motion m = exact_contact(kind, random);
  const double flat = std::ldexp(1.0, -random.below(45)), thin = std::ldexp(1.0, -random.below(45));
  const double shear = random.below(3) - 1;
  for (auto* points : {&m.start, &m.end})
    for (Point& p : *points) p = {p[0] + shear * p[1], flat * p[1], thin * (p[2] - shear * p[1])};
  if (random.coin()) nudge(m, random);
  return m;
}

Motion lattice(PairKind, Random& random) {
  const Index steps = 1 + random.below(3);
  Motion m;
  for (auto* points : {&m.start, &m.end})
    for (Point& p : *points) p = random.point_on_lattice(steps, 0.5);
  return m;
}

Motion degenerate(PairKind kind, Random& random) {
  Motion m = random.coin() ? lattice(kind, random) : exact_contact(kind, random);
  const auto merge = [&](std::size_t i, std::size_t j, bool at_start, bool at_end) {
    if (at_start) m.start[i] = m.start[j];
    if (at_end) m.end[i] = m.end[j];
  };
  const bool at_start = random.coin(), at_end = !at_start || random.coin();
  switch (random.below(6)) {
    case 0:
      merge(3, 2, at_start, at_end);
      break;  // no length, no area
    case 1:
      merge(3, 2, true, true), merge(1, kind == PairKind::edge_edge ? 0 : 2, at_start, at_end);
      break;
    case 2:
      m.end = m.start;
      break;  // at rest
    case 3:
      merge(0, 2, at_start, at_end);
      break;  // a common point
    case 4:
      merge(0, 2, at_start, at_end), merge(1, 3, at_start, at_end);
      break;  // coinciding edges
    default:  // collinear, parallel
      m.start[3] = m.start[2] + 2.0 * (m.start[1] - m.start[0]);
      m.end[3] = m.end[2] + (at_start ? 2.0 : -0.5) * (m.end[1] - m.end[0]);
  }
  return m;
}

Motion in_plane(PairKind kind, Random& random) {
  Motion m = random.coin() ? lattice(kind, random) : exact_contact(kind, random);
  const double slope_x = random.on_lattice(4, 0.25), slope_y = random.on_lattice(4, 0.25);
  const double other_slope = random.coin() ? slope_x : random.on_lattice(4, 0.25), rise = random.on_lattice(4, 0.25);
  for (Point& p : m.start) p[2] = slope_x * p[0] + slope_y * p[1];
  for (Point& p : m.end) p[2] = other_slope * p[0] + slope_y * p[1] + rise;
  return m;
}

Motion mirrored(PairKind kind, Random& random) {
  Motion m = random.coin() ? lattice(kind, random) : random_motion(kind, random);
  const auto mirror = [](Point p) { return Point{-p[0], p[1], p[2]}; };
  for (auto* points : {&m.start, &m.end}) {
    auto& p = *points;
    if (kind == PairKind::edge_edge) p[2] = mirror(p[0]), p[3] = mirror(p[1]);
    if (kind == PairKind::vertex_face) p[0][0] = 0, p[1][0] = 0, p[3] = mirror(p[2]);
    if (kind == PairKind::vertex_edge) p[0][0] = 0, p[2] = mirror(p[1]);
    if (kind == PairKind::vertex_vertex) p[1] = mirror(p[0]);
  }
  return m;
}

}  // namespace

const std::array<Family, 10> kFamilies{{{"random", random_motion},
                                        {"separated", separated},
                                        {"exact_contact", exact_contact},
                                        {"near_contact", near_contact},
                                        {"lattice", lattice},
                                        {"degenerate", degenerate},
                                        {"in_plane", in_plane},
                                        {"mirrored", mirrored},
                                        {"nudged", nudged},
                                        {"uneven", uneven}}};

const std::array<Placement, 6> kPlacements{{{"as made", 1, 0},
                                            {"far from origin", 1, 1e6},
                                            {"tiny", 1e-12, 0},
                                            {"huge", 1e12, 0},
                                            {"smallest", 0x1p-1000, 0},
                                            {"largest", 0x1p1000, 0}}};

const Family& family_named(std::string_view name) {
  return *std::find_if(kFamilies.begin(), kFamilies.end(), [&](const Family& f) { return f.name == name; });
}

Motion placed(Motion motion, const Placement& placement) {
  const Point offset{placement.offset, -placement.offset, 2 * placement.offset};
  for (auto* points : {&motion.start, &motion.end})
    for (Point& p : *points) p = placement.scale * p + offset;
  return motion;
}

Motion permuted(PairKind kind, const Motion& motion, Random& random) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  if (kind == PairKind::vertex_face) {
    std::swap(order[1], order[1 + static_cast<std::size_t>(random.below(3))]);
    if (random.coin()) std::swap(order[2], order[3]);
  } else if (kind == PairKind::vertex_edge) {
    if (random.coin()) std::swap(order[1], order[2]);
  } else if (kind == PairKind::vertex_vertex) {
    if (random.coin()) std::swap(order[0], order[1]);
  } else {
    if (random.coin()) std::swap(order[0], order[1]);
    if (random.coin()) std::swap(order[2], order[3]);
    if (random.coin()) std::swap(order[0], order[2]), std::swap(order[1], order[3]);
  }
  Motion result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.start[i] = motion.start[order[i]];
    result.end[i] = motion.end[order[i]];
  }
  return result;
}

}  // namespace tamis::test
