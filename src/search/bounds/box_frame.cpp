#include "search/bounds/box_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "search/bounds/packed_motion.hpp"
#include "search/bounds/scene_vertices.hpp"

namespace tamis {
namespace {

/// The roundings listed at BoxFrame::margin sum to 2^-24 + 2^-53.
constexpr float kRounding = 0x1p-23f;

/// The frame moves with its vertices where that makes it this many times narrower. This gains three bits of every
/// coordinate. (A smaller gain is not worth it.)
constexpr double kMuchNarrower = 8;

/// Half of the frame's width, and its middle at both ends of the step. The scale follows from these.
struct Extent {
  double half;
  Point middle, middle_at_end;
};

/// The frame moves only if most of the scene moves with it. Everything else would sweep across it.
Extent extent_of(const EndBoxes& boxes, std::size_t vertices) {
  const Box both = joined(boxes.start, boxes.end);
  const double half = std::max(boxes.start.half_width(), boxes.end.half_width());
  if (2 * boxes.count > vertices && kMuchNarrower * half < both.half_width())
    return {half, boxes.start.middle(), boxes.end.middle()};
  return {both.half_width(), both.middle(), both.middle()};
}

/// The extent of the vertices near the finest place, if it is kNarrower times narrower than `all`; else `all`. Its half
/// width is no less than the separation. Half of the separation widens all boxes.
Extent extent_of_finest(const SceneVertices& scene, double min_separation, const Extent& all) {
  constexpr double kNarrower = 64;  // six bits of the 17 that two kLaterMargins leave
  constexpr double kMost = 16;      // in an even cloud the farthest vertex is at two or three times the median
  std::array<SampledVertex, kMostSampled> room;
  const auto sample = std::span(room).first(sample_size(scene.count()));
  scene.sample(sample);
  const std::optional<FinePlace> place = place_finer_than(all.half / kNarrower, sample);
  if (!place) return all;
  Extent finest = extent_of(scene.boxes_near(*place, kMost * place->radius), scene.count());
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

BoxFrame frame_of(const SceneVertices& scene, double min_separation) {
  const EndBoxes boxes = scene.boxes();
  const Extent all = extent_of(boxes, scene.count()), finest = extent_of_finest(scene, min_separation, all);
  BoxFrame frame{};
  frame.origin = finest.middle;
  frame.origin_at_end = finest.middle_at_end;
  // One binary digit to spare. So rounding of origin and half width stays inside [-1,1].
  const int exponent = finest.half > 0 ? std::min(-2 - std::ilogb(finest.half), 1000) : 0;
  frame.scale = std::ldexp(1.0, exponent);
  frame.widening = boxes.end.half_width() / boxes.start.half_width();
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
