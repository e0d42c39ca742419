#include "bounds/box_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bounds/box.hpp"
#include "bounds/packed_motion.hpp"
#include "numerics/in_parts.hpp"

namespace tamis {
namespace {

/// 2^-23: the roundings listed at BoxFrame::margin sum to under half of it.
constexpr float kRounding = 0x1p-23f;

/// Where some vertices start and where they end.
struct Ends {
  Box start, end;

  void include(const double* at_start, const double* at_end) {
    start.include(Point{at_start[0], at_start[1], at_start[2]});
    end.include(Point{at_end[0], at_end[1], at_end[2]});
  }
};

/// Of those vertices of which is_one(start, end) holds.
template <class F>
Ends ends_of(const Step& step, std::span<const Index> used, const F& is_one) {
  const auto join = [](const Ends& a, const Ends& b) { return Ends{joined(a.start, b.start), joined(a.end, b.end)}; };
  return joined_parts(used, kVerticesPerPart, Ends(), join, [&](std::span<const Index> some) {
    Ends ends;
    for (const Index v : some)
      if (is_one(step.start[v], step.end[v])) ends.include(step.start[v], step.end[v]);
    return ends;
  });
}

/// The frame moves with the scene where that makes it so many times narrower, which is three bits of every coordinate.
/// (Where it gained less it would only change the last digits of answers.)
constexpr double kMuchNarrower = 8;

/// Half of the frame's width, and where it lies: not yet its scale.
struct Extent {
  double half;
  Point middle, middle_at_end;
};

Extent extent_of(const Ends& ends) {
  const Box both = joined(ends.start, ends.end);
  const double half = std::max(ends.start.half_width(), ends.end.half_width());
  if (kMuchNarrower * half < both.half_width()) return {half, ends.start.middle(), ends.end.middle()};
  return {both.half_width(), both.middle(), both.middle()};
}

/// Medians of a few vertices' coordinates, and of their distances from these, along the axis where each is largest and
/// at either end.
struct Medians {
  Point start, end;
  double distance;

  double distance_of(const double* at_start, const double* at_end) const {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      largest = std::max({largest, std::fabs(at_start[k] - start[k]), std::fabs(at_end[k] - end[k])});
    return largest;
  }
};

/// REQUIRES: there are vertices.
Medians medians_of(const Step& step, std::span<const Index> used) {
  constexpr std::size_t kSample = 15;
  std::array<Index, kSample> sample;
  for (std::size_t i = 0; i < kSample; ++i) sample[i] = used[(2 * i + 1) * used.size() / (2 * kSample)];
  const auto median = [&](const auto& value_of) {
    std::array<double, kSample> values;
    std::ranges::transform(sample, values.begin(), value_of);
    std::ranges::nth_element(values, values.begin() + kSample / 2);
    return values[kSample / 2];
  };
  Medians medians;
  for (std::size_t k = 0; k < 3; ++k) {
    medians.start[k] = median([&](Index v) { return step.start[v][k]; });
    medians.end[k] = median([&](Index v) { return step.end[v][k]; });
  }
  medians.distance = median([&](Index v) { return medians.distance_of(step.start[v], step.end[v]); });
  return medians;
}

/// Where most vertices are, if that is so many times narrower than where all are; else `all`. It is no narrower than
/// the separation, by which all boxes are widened.
Extent extent_of_most(const Step& step, std::span<const Index> used, double min_separation, const Extent& all) {
  constexpr std::size_t kFewVertices = 64;  // for which looking for outliers would take a hundredth of their questions
  constexpr double kOutlier = 64;           // six bits of the 17 that kLaterMargin leaves
  constexpr double kMost = 16;              // of an even cloud the farthest is at two or three medians
  if (used.size() < kFewVertices) return all;
  const Medians medians = medians_of(step, used);
  if (!(medians.distance < all.half / kOutlier)) return all;
  Extent most = extent_of(ends_of(step, used, [&](const double* start, const double* end) {
    return medians.distance_of(start, end) <= kMost * medians.distance;
  }));
  most.half = std::max(most.half, min_separation);
  return 0 < most.half && most.half < all.half / kOutlier ? most : all;
}

/// (to - from) scale, in the order in which neither overflows, nor loses more than underflows.
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
  const Extent all = extent_of(ends), most = extent_of_most(step, used, min_separation, all);
  BoxFrame frame{};
  frame.origin = most.middle;
  frame.origin_at_end = most.middle_at_end;
  // One binary digit to spare, so that rounding of origin and half width stays inside [-1,1].
  const int exponent = most.half > 0 ? std::min(-2 - std::ilogb(most.half), 1000) : 0;
  frame.scale = std::ldexp(1.0, exponent);
  frame.widening = ends.end.half_width() / ends.start.half_width();
  frame.has_outliers = most.half < all.half;
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
