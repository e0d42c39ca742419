#include "search/bounds/packed_motion.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

#include "numbers/assert.hpp"
#include "numbers/in_parts.hpp"
#include "search/bounds/box.hpp"
#include "search/bounds/scene_vertices.hpp"
#include "search/bounds/shared_motion.hpp"

namespace tamis {
namespace {

std::uint64_t different_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) ^ std::bit_cast<std::uint64_t>(b);
}

/// The error that rounding hides of an outlier, or of a vertex whose radius reaches beyond the frame. 0 for other
/// vertices: the margins of boxes cover them. `margin`: the error at a reach of 1.
float hidden_of(const BoxVertex& vertex, float margin) {
  constexpr auto kFarthest = static_cast<float>(BoxFrame::kFarthest);
  const float reach = vertex.largest_coordinate() + vertex.at[BoxVertex::kRadius];
  if (reach <= 1) return 0;
  return reach < kFarthest ? margin * reach : 4 * kFarthest;
}

}  // namespace

bool PackedMotion::assign(const Step& step, std::span<const Index> used, const Separations& new_separations,
                          const BoxFrame* of_scene) {
  TAMIS_ASSERT(step.start.count() == step.end.count());
  TAMIS_ASSERT(new_separations.radii.empty() ||
               new_separations.radii.size() == static_cast<std::size_t>(step.start.count()));
  const bool is_first = vertices.empty();
  const double last_separation = std::exchange(separations, new_separations).fixed;
  const BoxFrame last_frame =
      std::exchange(frame, of_scene ? *of_scene : frame_of(StepVertices(step, used), separations.fixed));
  const auto count = static_cast<std::size_t>(step.start.count());
  vertices.resize(count);
  box_vertices.resize(count);
  const auto bits =
      joined_parts(used, kVerticesPerPart, std::uint64_t{0}, std::bit_or<>(), [&](std::span<const Index> some) {
        return frame.has_outliers ? load<true>(some, step) : load<false>(some, step);
      });
  return is_first || frame != last_frame || (bits | different_bits(last_separation, separations.fixed)) != 0;
}

template <bool has_outliers>
std::uint64_t PackedMotion::load(std::span<const Index> some, const Step& step) {
  const auto rounded = [](double coordinate) {
    constexpr double kFarthest = BoxFrame::kFarthest;
    return static_cast<float>(has_outliers ? std::clamp(coordinate, -kFarthest, kFarthest) : coordinate);
  };
  std::uint64_t bits = 0;
  for (const Index v : some) {
    PackedVertex& packed = vertices[static_cast<std::size_t>(v)];
    BoxVertex& box = box_vertices[static_cast<std::size_t>(v)];
    const double *start = step.start[v], *end = step.end[v];
    const double radius = separations.radii.empty() ? 0 : separations.radii[static_cast<std::size_t>(v)];
    bits |= different_bits(packed.at[3], radius);
    packed.at[3] = radius;
    box.at[BoxVertex::kRadius] = separations.radii.empty() ? 0 : frame.distance(radius);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bits |= different_bits(packed.at[axis], start[axis]) | different_bits(packed.at[4 + axis], end[axis]);
      packed.at[axis] = start[axis];
      packed.at[4 + axis] = end[axis];
      box.at[axis] = rounded((start[axis] - frame.origin[axis]) * frame.scale);
      box.at[3 + axis] = rounded((end[axis] - frame.origin_at_end[axis]) * frame.scale);
    }
    if (has_outliers) box.at[BoxVertex::kRadius] += hidden_of(box, BoxFrame::kOutlierMargin);
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
    const auto i = static_cast<std::size_t>(v);
    const float hidden = frame.has_outliers ? hidden_of(box_vertices[i], 2 * BoxFrame::kLeastMargin) : 0;
    const bool is_anywhere = hidden > BoxFrame::kFarthest;
    const Vec3<double> residual = is_anywhere ? Vec3<double>{} : shared.residual_of(vertices[i], frame);
    residuals[i] = {{0, 0, 0, static_cast<float>(residual.x), static_cast<float>(residual.y),
                     static_cast<float>(residual.z), hidden}};
    if (!is_outlier(v)) box.include(Point{residual.x, residual.y, residual.z});
  }
  return box;
}

}  // namespace tamis
