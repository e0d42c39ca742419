// Finds where a step has its shortest edges: boxes need the precision of floats there.
#pragma once
#include <optional>
#include <span>

#include "tamis/step.hpp"

namespace tamis {

/// A place at each end of the step; half of the fine vertices are within `radius` of it.
struct FinePlace {
  Point start, end;
  double radius = 0;

  /// The largest distance of a vertex from the place along any axis, at the end of the step where it is larger.
  double distance_to(const double* at_start, const double* at_end) const;
};

/// The place of those vertices that lie nearest to the next vertex by number, which most often is the other end of an
/// edge. Nothing if they spread over more than `width`, or if there are too few vertices for speed to matter. A guess
/// from a sample; it depends on the step alone.
std::optional<FinePlace> place_finer_than(double width, const Step& step, std::span<const Index> used);

}  // namespace tamis
