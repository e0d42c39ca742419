// Where a step has its shortest edges: there boxes need their floats.
#pragma once
#include <optional>
#include <span>

#include "tamis/step.hpp"

namespace tamis {

/// A place at either end of the step, and how far around it half of the fine vertices are.
struct FinePlace {
  Point start, end;
  double radius = 0;

  /// Of a vertex, at the end where it is farther and along the axis where it is.
  double distance_to(const double* at_start, const double* at_end) const;
};

/// Where the vertices are that lie nearest to the next one by number, which most often is at the other end of an edge.
/// Nothing if they spread over more than `width`, or there are so few vertices that nobody waits for them. A guess from
/// a sample, made of the step alone.
std::optional<FinePlace> place_finer_than(double width, const Step& step, std::span<const Index> used);

}  // namespace tamis
