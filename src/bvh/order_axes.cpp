#include "bvh/order_axes.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/box.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// Halfway; and how much of its way a feature is then from where it starts.
constexpr float kHalf = 0.5f;
/// Blocks by place alone serve a search for a first contact, which comes before they have parted, unless they part
/// sooner than after this part of the step.
constexpr double kSoon = 0.5;
/// Where neighbours go together an order by ways parts layers, and spreads blocks at the start little: by no more than
/// this, counted until blocks by place alone are twice as wide.
constexpr double kMoreSpread = 1.25;

Point lengths(const Box& box) { return {box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]}; }

/// Sum of what one box is long along an axis times what the other is along another axis.
double across(const Box& a, const Box& b) {
  const auto [x, y, z] = lengths(b);
  const Point along = lengths(a);
  return along[0] * (y + z) + along[1] * (z + x) + along[2] * (x + y);
}

/// Of blocks in an order, the sum of their boxes' areas, with which a traversal's cost grows: as wide as their points
/// are apart at its time and, from then on, as these part by the differences of their ways. Some that part along one
/// line have no area of their own, but make their boxes longer.
struct Spread {
  double apart = 0, along = 0, parting = 0;

  void include(const Box& where, const Box& how_far) {
    apart += across(where, where);
    along += 2 * across(where, how_far);
    parting += across(how_far, how_far);
  }
  double until(double t) const { return apart + t * along + t * t * parting; }
  /// Are they twice as wide, four times the area, before the end of the step?
  bool is_long() const { return until(1) > kTwiceAsWide * apart; }
  /// The part of the step after which they are. REQUIRES: is_long().
  double time() const {
    TAMIS_ASSERT(is_long());
    if (apart == 0) return 0;
    const double more = (kTwiceAsWide - 1) * apart;
    return 2 * more / (along + std::sqrt(along * along + 4 * parting * more));
  }

 private:
  static constexpr double kTwiceAsWide = 4;
};

/// Every sixteenth of the points, in this order, sixteen a block.
Spread spread_of(const PackedMotion& motion, std::span<const Index> points, const OrderAxes& by, Split split) {
  const std::size_t count = points.size() / kBlock;
  CenterStore store(count, by.count());
  const Centers centers = store.view();
  const auto coordinates = [&](Index vertex) -> const float* {
    return motion.box_vertices[static_cast<std::size_t>(vertex)].at;
  };
  const auto way = [](const float* at, int axis) { return at[3 + axis] - at[axis]; };
  const auto place = [&](const float* at, int axis) { return at[axis] + by.time * way(at, axis); };
  for (std::size_t i = 0; i < count; ++i) {
    const float* at = coordinates(centers.feature[i] = points[i * kBlock]);
    for (int axis = 0; axis < 3; ++axis) centers.at[axis][i] = place(at, axis);
    for (int axis = 0; axis < by.count() - 3; ++axis) centers.at[3 + axis][i] = by.way * way(at, axis);
  }
  order_in_space(centers, count, split, [] {});
  Spread spread;
  for (std::size_t first = 0; first < count; first += kBlock) {
    Box where, how_far;
    for (std::size_t i = first; i < std::min(count, first + kBlock); ++i) {
      const float* at = coordinates(centers.feature[i]);
      where.include(Point{place(at, 0), place(at, 1), place(at, 2)});
      how_far.include(Point{way(at, 0), way(at, 1), way(at, 2)});
    }
    spread.include(where, how_far);
  }
  return spread;
}

OrderAxes axes_of_whole_step(const PackedMotion& motion, std::span<const Index> points, Split split) {
  return {kHalf, spread_of(motion, points, {kHalf}, split).is_long() ? kHalf : 0};
}

}  // namespace

OrderAxes order_axes(const PackedMotion& motion, std::span<const Index> points, LooksAt looks_at, Split split) {
  if (looks_at == LooksAt::whole_step) return axes_of_whole_step(motion, points, split);
  const Spread by_place = spread_of(motion, points, {0}, split);
  if (!by_place.is_long()) return axes_of_whole_step(motion, points, split);
  const double t = by_place.time();
  if (looks_at == LooksAt::start && t > kSoon) return {0};
  const Spread by_way = spread_of(motion, points, {0, kHalf}, split);
  if (by_way.until(t) < kMoreSpread * by_place.until(t)) return axes_of_whole_step(motion, points, split);
  return {0, t > kSoon ? 0 : static_cast<float>(t)};
}

}  // namespace tamis
