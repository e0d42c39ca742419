#include "bounds/box_frame.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/box.hpp"
#include "bounds/fine_place.hpp"
#include "bounds/packed_motion.hpp"
#include "numerics/in_parts.hpp"

namespace tamis {
namespace {

/// The roundings listed at BoxFrame::margin sum to 2^-24 + 2^-53.
constexpr float kRounding = 0x1p-23f;

/// The boxes of some vertices at both ends of the step, and how many vertices they hold.
struct Ends {
  Box start, end;
  std::size_t count = 0;

  void include(const double* at_start, const double* at_end) {
    ++count;
    start.include(Point{at_start[0], at_start[1], at_start[2]});
    end.include(Point{at_end[0], at_end[1], at_end[2]});
  }
};

/// Of the vertices for which is_one(start, end) holds.
template <class F>
Ends ends_of(const Step& step, std::span<const Index> used, const F& is_one) {
  const auto join = [](const Ends& a, const Ends& b) {
    return Ends{joined(a.start, b.start), joined(a.end, b.end), a.count + b.count};
  };
  return joined_parts(used, kVerticesPerPart, Ends(), join, [&](std::span<const Index> some) {
    Ends ends;
    for (const Index v : some)
      if (is_one(step.start[v], step.end[v])) ends.include(step.start[v], step.end[v]);
    return ends;
  });
}

/// The frame moves with its vertices where that makes it this many times narrower, which gains three bits of every
/// coordinate. (A smaller gain would only change the last digits of answers.)
constexpr double kMuchNarrower = 8;

/// Half of the frame's width, and its middle at both ends of the step; the scale follows from these.
struct Extent {
  double half;
  Point middle, middle_at_end;
};

/// The frame moves only if most of the scene moves with it; everything else would sweep across it.
Extent extent_of(const Ends& ends, std::size_t vertices) {
  const Box both = joined(ends.start, ends.end);
  const double half = std::max(ends.start.half_width(), ends.end.half_width());
  if (2 * ends.count > vertices && kMuchNarrower * half < both.half_width())
    return {half, ends.start.middle(), ends.end.middle()};
  return {both.half_width(), both.middle(), both.middle()};
}

/// The extent of the vertices near the finest place, if it is kNarrower times narrower than `all`; else `all`. Its half
/// width is no less than the separation, half of which widens all boxes.
Extent extent_of_finest(const Step& step, std::span<const Index> used, double min_separation, const Extent& all) {
  constexpr double kNarrower = 64;  // six bits of the 17 that two kLaterMargins leave
  constexpr double kMost = 16;      // in an even cloud the farthest vertex is at two or three times the median
  const std::optional<FinePlace> place = place_finer_than(all.half / kNarrower, step, used);
  if (!place) return all;
  const auto is_near = [&](const double* start, const double* end) {
    return place->distance_to(start, end) <= kMost * place->radius;
  };
  Extent finest = extent_of(ends_of(step, used, is_near), used.size());
  finest.half = std::max(finest.half, min_separation);
  return 0 < finest.half && finest.half < all.half / kNarrower ? finest : all;
}

/// (to - from) scale, in the order that neither overflows nor loses more than what underflows.
double scaled_difference(double to, double from, double scale) {
  return scale < 1 ? to * scale - from * scale : (to - from) * scale;
}

Vec3<double> scaled_difference(const double* to, const double* from, double scale) {
  const auto on = [&](int axis) { return scaled_difference(to[axis], from[axis], scale); };
  return {on(0), on(1), on(2)};
}

}  // namespace

BoxFrame frame_of(const Step& step, std::span<const Index> used, double min_separation) {
  const Ends ends = ends_of(step, used, [](const double*, const double*) { return true; });
  const Extent all = extent_of(ends, used.size()), finest = extent_of_finest(step, used, min_separation, all);
  BoxFrame frame{};
  frame.origin = finest.middle;
  frame.origin_at_end = finest.middle_at_end;
  // One binary digit to spare, so that rounding of origin and half width stays inside [-1,1].
  const int exponent = finest.half > 0 ? std::min(-2 - std::ilogb(finest.half), 1000) : 0;
  frame.scale = std::ldexp(1.0, exponent);
  frame.widening = ends.end.half_width() / ends.start.half_width();
  frame.has_outliers = finest.half < all.half;
  frame.margin = kRounding + frame.distance(0.5 * min_separation);
  return frame;
}

Vec3<double> BoxFrame::place(const PackedVertex& vertex) const {
  return scaled_difference(vertex.start(), origin.data(), scale);
}

float BoxFrame::distance(double distance) const {
  constexpr double kMeetsAll = 3;
  return static_cast<float>(std::min(distance * scale * (1 + 0x1p-20), has_outliers ? kFarthest : kMeetsAll));
}

Vec3<double> BoxFrame::displacement(const PackedVertex& vertex) const {
  if (origin == origin_at_end) return scaled_difference(vertex.end(), vertex.start(), scale);
  return scaled_difference(vertex.end(), origin_at_end.data(), scale) - place(vertex);
}

}  // namespace tamis
