#include "io/view/quantised.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamis::io {
namespace {

/// A feature of a millionth of the scene still has sixteen steps of the grid.
constexpr std::uint32_t kFinest = (std::uint32_t{1} << 24) - 1;

void set_grid(const Recording& recording, QuantisedFrames& result) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Point lowest{kFar, kFar, kFar}, highest{-kFar, -kFar, -kFar};
  for (const auto& frame : recording.frames)
    for (const Index v : recording.mesh.points())
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = frame[static_cast<std::size_t>(v)][axis];
        lowest[axis] = std::min(lowest[axis], x);
        highest[axis] = std::max(highest[axis], x);
      }
  // Divided before they are subtracted, lest the difference of two huge coordinates overflow.
  double spacing = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacing = std::max(spacing, highest[axis] / kFinest - lowest[axis] / kFinest);
  result.lowest = lowest;
  if (spacing > 0) result.spacing = spacing;
}

}  // namespace

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
