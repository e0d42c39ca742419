#include "files/view/quantised.hpp"

#include <algorithm>
#include <cmath>

#include "files/extent.hpp"

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

std::string_view why_not_quantised(const Recording& recording) {
  const Box box = box_of(recording);
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, box.highest[axis] - box.lowest[axis]);
  if (!std::isfinite(2 * longest)) return "the mesh is too large for a page, which doubles place: scale it down";
  // Below, a double has fewer digits, and the page's numbers in the mesh's unit overflow.
  if (longest > 0 && longest / kFinest < std::numeric_limits<double>::min())
    return "the mesh is too small for a page, which doubles place: scale it up";
  return {};
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
