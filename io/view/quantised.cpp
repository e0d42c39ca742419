#include "io/view/quantised.hpp"

#include <algorithm>
#include <cmath>

#include "io/extent.hpp"

namespace tamis::io {
namespace {

/// The grid's largest integer: a feature of a millionth of the scene still spans sixteen steps.
constexpr std::uint32_t kFinest = (std::uint32_t{1} << 24) - 1;

Box box_of(const Recording& recording) {
  Box box;
  for (const auto& frame : recording.frames) box.add(recording.mesh, frame);
  return box;
}

void set_grid(const Recording& recording, QuantisedFrames& result) {
  const Box box = box_of(recording);
  double spacing = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacing = std::max(spacing, (box.highest[axis] - box.lowest[axis]) / kFinest);
  result.lowest = box.lowest;
  if (spacing > 0) result.spacing = spacing;
}

}  // namespace

bool can_quantise(const Recording& recording) {
  const Box box = box_of(recording);
  bool is_finite = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    is_finite = is_finite && std::isfinite(2 * (box.highest[axis] - box.lowest[axis]));
  return is_finite;
}

QuantisedFrames quantise(const Recording& recording) {
  QuantisedFrames result;
  set_grid(recording, result);
  for (const auto& frame : recording.frames) {
    std::vector<std::uint32_t>& rows = result.frames.emplace_back(3 * frame.size(), 0);
    for (const Index v : recording.mesh.points())
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = frame[static_cast<std::size_t>(v)][axis];
        const double steps = std::round(x / result.spacing - result.lowest[axis] / result.spacing);
        const double clamped = std::clamp(steps, 0.0, static_cast<double>(kFinest));
        rows[3 * static_cast<std::size_t>(v) + axis] = static_cast<std::uint32_t>(clamped);
        result.error = std::max(result.error, std::abs(result.lowest[axis] + result.spacing * clamped - x));
      }
  }
  return result;
}

}  // namespace tamis::io
