// The beginning [0, T] of a step, as a step of its own. For steps so long that the floats of the boxes make a point of
// the scene at t=0.
#pragma once
#include <span>

#include "search/coherence/kept_lists.hpp"

namespace tamis {

/// T, a power of two: until T no two vertices move against each other by much more than a sixteenth of the scene's
/// width at t=0. It is 1 unless they move very far. `widening`: BoxFrame::widening, which spares most steps a look at
/// the vertices. REQUIRES (not checked: O(n)): finite positions of the points.
double beginning_of_long_step(const Step& step, std::span<const Index> points, double widening);

/// The listing of pairs that come within their separations on [0, length]. It has a step of its own, which refers to
/// the start of the query's step. Its deviation is rounding. REQUIRES: 0 < length <= 1, a power of two.
Listing listing_of_beginning(const Query& query, std::span<const Index> points, double length);

}  // namespace tamis
