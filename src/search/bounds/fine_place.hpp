// Finds where a step has its shortest edges. Boxes need the precision of floats there.
#pragma once
#include <optional>
#include <span>

#include "tamis/contact.hpp"

namespace tamis {

/// A place at each end of the step. Half of the fine vertices are within `radius` of it.
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

/// How many of `count` vertices are the sample: an even number, at most kMostSampled; 0 if there are too few vertices
/// for speed to matter.
std::size_t sample_size(std::size_t count);
/// Which of `count` vertices, by number, is vertex i of the sample. After each with an even i comes the next vertex.
/// REQUIRES: i < sample_size(count).
std::size_t sample_place(std::size_t count, std::size_t i);

inline constexpr std::size_t kMostSampled = 256;

/// Centre of the finest region: the vertices closest to their successor in index order. Successive indices are usually
/// joined by an edge. Nothing if they spread over more than `width`, or if the sample is empty. A guess: it depends on
/// the sample alone.
std::optional<FinePlace> place_finer_than(double width, std::span<const SampledVertex> sample);

}  // namespace tamis
