#include "search/bvh/order_axes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numbers/assert.hpp"
#include "search/bounds/box.hpp"

namespace tamis {
namespace {

/// The time of positions in the usual order, and the weight of displacements beside positions. Half of a displacement
/// is done by that time.
constexpr float kHalf = 0.5f;
/// An order by positions at the start alone serves a search for a first contact, which comes before blocks have spread.
/// The exception: blocks that double their width before this time.
constexpr double kSoon = 0.5;
/// An order by displacements, too, is taken if its blocks are larger by less than this factor when blocks by position
/// alone are twice as wide. Where neighbours move together, displacements only separate layers.
constexpr double kMoreSpread = 1.25;

Point lengths(const Box& box) { return {box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]}; }

/// The sum, over ordered pairs of different axes, of `a`'s length along the first times `b`'s along the second.
double mixed_area(const Box& a, const Box& b) {
  const auto [x, y, z] = lengths(b);
  const Point along = lengths(a);
  return along[0] * (y + z) + along[1] * (z + x) + along[2] * (x + y);
}

/// How the area of an order's blocks spreads over time. A traversal's cost grows with it. Boxes are as wide as the
/// positions of their points at the order's time, and widen by the differences of the displacements. The sum of the
/// areas is a quadratic in time. Points that separate along a line add no area of their own. But they make boxes
/// longer.
struct Spread {
  double constant = 0, linear = 0, quadratic = 0;  ///< coefficients of the area

  void include(const Box& positions, const Box& displacements) {
    constant += mixed_area(positions, positions);
    linear += 2 * mixed_area(positions, displacements);
    quadratic += mixed_area(displacements, displacements);
  }
  double area_at(double t) const { return constant + t * linear + t * t * quadratic; }
  /// True if the blocks are twice as wide, of four times the area, before the end of the step.
  bool doubles() const { return area_at(1) > kTwiceAsWide * constant; }
  /// The time at which they are. REQUIRES: doubles().
  double doubling_time() const {
    TAMIS_ASSERT(doubles());
    if (constant == 0) return 0;
    const double more = (kTwiceAsWide - 1) * constant;
    return 2 * more / (linear + std::sqrt(linear * linear + 4 * quadratic * more));
  }

 private:
  static constexpr double kTwiceAsWide = 4;
};

/// The spread of blocks of sixteen points, made of every sixteenth of `points` in the order of `by`.
template <int axes>
Spread spread_of(const PackedMotion& motion, std::span<const Index> points, const OrderAxes& by) {
  std::vector<Center<axes>> centers(points.size() / kBlock);
  const auto coordinates = [&](Index vertex) -> const float* {
    return motion.box_vertices[static_cast<std::size_t>(vertex)].at;
  };
  const auto displacement = [](const float* at, int axis) { return at[3 + axis] - at[axis]; };
  const auto position = [&](const float* at, int axis) { return at[axis] + by.time * displacement(at, axis); };
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const Index point = points[i * kBlock];
    centers[i] = by.center<axes>(coordinates(point), 1, point);
  }
  order_in_space<axes>(centers, [] {});
  Spread spread;
  for (std::size_t first = 0; first < centers.size(); first += kBlock) {
    Box positions, displacements;
    for (std::size_t i = first; i < std::min(centers.size(), first + kBlock); ++i) {
      const float* at = coordinates(centers[i].feature);
      positions.include(Point{position(at, 0), position(at, 1), position(at, 2)});
      displacements.include(Point{displacement(at, 0), displacement(at, 1), displacement(at, 2)});
    }
    if (2 * std::max(positions.half_width(), displacements.half_width()) <= double{kWidest})
      spread.include(positions, displacements);
  }
  return spread;
}

OrderAxes axes_of_whole_step(const PackedMotion& motion, std::span<const Index> points) {
  return {kHalf, spread_of<3>(motion, points, {kHalf}).doubles() ? kHalf : 0};
}

}  // namespace

OrderAxes order_axes(const PackedMotion& motion, std::span<const Index> points, LooksAt looks_at) {
  if (looks_at == LooksAt::whole_step) return axes_of_whole_step(motion, points);
  const Spread by_position = spread_of<3>(motion, points, {0});
  if (!by_position.doubles()) return axes_of_whole_step(motion, points);
  const double t = by_position.doubling_time();
  if (looks_at == LooksAt::start && t > kSoon) return {0};
  const Spread by_displacement = spread_of<6>(motion, points, {0, kHalf});
  if (by_displacement.area_at(t) < kMoreSpread * by_position.area_at(t)) return axes_of_whole_step(motion, points);
  return {0, t > kSoon ? 0 : static_cast<float>(t)};
}

}  // namespace tamis
