// Finds where a step has its shortest edges: boxes need the precision of floats there.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "tamis/contact.hpp"

namespace tamis {

/// A place at each end of the step; half of the fine vertices are within `radius` of it.
struct FinePlace {
  Point start, end;
  double radius = 0;

  /// The largest distance of a vertex from the place along any axis, at the end of the step where it is larger.
  double distance_to(const double* at_start, const double* at_end) const;
};

/// Where a vertex of the sample is at both ends of the step.
struct SampledVertex {
  Point start, end;
};

/// Which of `count` vertices, by number, are the sample: vertices in even places of this list, each followed by the
/// next vertex. None if there are too few vertices for speed to matter.
std::vector<std::size_t> sample_places(std::size_t count);

/// The place of those vertices that lie nearest to the next vertex by number, which most often is the other end of an
/// edge. Nothing if they spread over more than `width`, or if there is no sample. A guess; it depends on the sample
/// alone.
std::optional<FinePlace> place_finer_than(double width, std::span<const SampledVertex> sample);

}  // namespace tamis
