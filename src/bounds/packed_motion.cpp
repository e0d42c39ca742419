#include "bounds/packed_motion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

#include "bounds/box.hpp"
#include "bounds/shared_motion.hpp"
#include "numerics/assert.hpp"
#include "numerics/in_parts.hpp"

namespace tamis {
namespace {

/// 2^-23: the roundings listed at BoxFrame::margin sum to under half of it.
constexpr float kRounding = 0x1p-23f;

/// Rounded up with room for what is added to it; two boxes widened by kFarthest each meet wherever they are.
float box_distance(double distance) {
  constexpr double kFarthest = 3.0;
  return static_cast<float>(std::min(distance * (1 + 0x1p-20), kFarthest));
}

Box box_of_some(const Positions& positions, std::span<const Index> some) {
  Box box;
  for (const Index v : some) {
    const double* p = positions[v];
    box.include(Point{p[0], p[1], p[2]});
  }
  return box;
}

Box box_of(const Positions& positions, std::span<const Index> used) {
  return joined_parts(used, kVerticesPerPart, Box(), joined,
                      [&](std::span<const Index> some) { return box_of_some(positions, some); });
}

/// The frame moves with the scene where that makes it so many times narrower, which is three bits of every coordinate.
/// (Where it gained less it would only change the last digits of answers.)
constexpr double kMuchNarrower = 8;

BoxFrame frame_of(const Step& step, std::span<const Index> used, double min_separation) {
  const Box start = box_of(step.start, used), end = box_of(step.end, used), both = joined(start, end);
  double half = std::max(start.half_width(), end.half_width());
  const bool moves_along = kMuchNarrower * half < both.half_width();
  if (!moves_along) half = both.half_width();
  BoxFrame frame{};
  frame.origin = (moves_along ? start : both).middle();
  frame.origin_at_end = (moves_along ? end : both).middle();
  // One binary digit to spare, so that rounding of origin and half width stays inside [-1,1].
  const int exponent = half > 0 ? std::min(-2 - std::ilogb(half), 1000) : 0;
  frame.scale = std::ldexp(1.0, exponent);
  frame.widening = end.half_width() / start.half_width();
  frame.margin = kRounding + box_distance(0.5 * (min_separation * frame.scale));
  return frame;
}

/// (to - from) scale, in the order in which neither overflows, nor loses more than underflows.
double scaled_difference(double to, double from, double scale) {
  return scale < 1 ? to * scale - from * scale : (to - from) * scale;
}

Vec3<double> scaled_difference(const double* to, const double* from, double scale) {
  const auto on = [&](int axis) { return scaled_difference(to[axis], from[axis], scale); };
  return {on(0), on(1), on(2)};
}

/// Those in which two numbers differ.
std::uint64_t different_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) ^ std::bit_cast<std::uint64_t>(b);
}

}  // namespace

Vec3<double> BoxFrame::place(const PackedVertex& vertex) const {
  return scaled_difference(vertex.start(), origin.data(), scale);
}

Vec3<double> BoxFrame::displacement(const PackedVertex& vertex) const {
  if (origin == origin_at_end) return scaled_difference(vertex.end(), vertex.start(), scale);
  return scaled_difference(vertex.end(), origin_at_end.data(), scale) - place(vertex);
}

bool PackedMotion::assign(const Step& step, std::span<const Index> used, const Separations& new_separations) {
  TAMIS_ASSERT(step.start.count() == step.end.count());
  TAMIS_ASSERT(new_separations.radii.empty() ||
               new_separations.radii.size() == static_cast<std::size_t>(step.start.count()));
  const bool is_first = vertices.empty();
  const double last_separation = std::exchange(separations, new_separations).fixed;
  frame = frame_of(step, used, separations.fixed);
  const auto count = static_cast<std::size_t>(step.start.count());
  vertices.resize(count);
  box_vertices.resize(count);
  const auto bits = joined_parts(used, kVerticesPerPart, std::uint64_t{0}, std::bit_or<>(),
                                 [&](std::span<const Index> some) { return load(some, step); });
  return is_first || (bits | different_bits(last_separation, separations.fixed)) != 0;
}

std::uint64_t PackedMotion::load(std::span<const Index> some, const Step& step) {
  std::uint64_t bits = 0;
  for (const Index v : some) {
    PackedVertex& packed = vertices[static_cast<std::size_t>(v)];
    BoxVertex& box = box_vertices[static_cast<std::size_t>(v)];
    const double *start = step.start[v], *end = step.end[v];
    const double radius = separations.radii.empty() ? 0 : separations.radii[static_cast<std::size_t>(v)];
    bits |= different_bits(packed.at[3], radius);
    packed.at[3] = radius;
    box.at[BoxVertex::kRadius] = box_distance(radius * frame.scale);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bits |= different_bits(packed.at[axis], start[axis]) | different_bits(packed.at[4 + axis], end[axis]);
      packed.at[axis] = start[axis];
      packed.at[4 + axis] = end[axis];
      box.at[axis] = static_cast<float>((start[axis] - frame.origin[axis]) * frame.scale);
      box.at[3 + axis] = static_cast<float>((end[axis] - frame.origin_at_end[axis]) * frame.scale);
    }
  }
  return bits;
}

void PackedMotion::assign_residuals(std::span<const Index> used, const SharedMotion& shared) {
  residuals.resize(vertices.size());
  const Box box = joined_parts(used, kVerticesPerPart, Box(), joined,
                               [&](std::span<const Index> some) { return load_residuals(some, shared); });
  spread = static_cast<float>(box.extent());
}

Box PackedMotion::load_residuals(std::span<const Index> some, const SharedMotion& shared) {
  Box box;
  for (const Index v : some) {
    const Vec3<double> residual = shared.residual_of(vertices[static_cast<std::size_t>(v)], frame);
    residuals[static_cast<std::size_t>(v)] = {
        {0, 0, 0, static_cast<float>(residual.x), static_cast<float>(residual.y), static_cast<float>(residual.z)}};
    box.include(Point{residual.x, residual.y, residual.z});
  }
  return box;
}

}  // namespace tamis
