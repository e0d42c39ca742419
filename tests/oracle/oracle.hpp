// The oracle: the exact answer to "do these two closed features touch?", slow, and obviously right. It shares no code
// with the library, only the types of the public headers.
//
// A feature pair becomes a moving triangle and the origin. Vertex p and face abc touch when the origin lies in the
// triangle (a-p, b-p, c-p). Edges a0a1 and b0b1 touch when the origin lies in the parallelogram of the differences
// a_i - b_j, that is in one of its two halves. For a vertex and an edge the triangle lies in a line, for two vertices
// in a point. The origin lies in a triangle, degenerate or not, when it lies
//   on a side q r:   q x r = 0 and q.r <= 0, or
//   in the interior: det = 0 and the three cross products of the corners point the same way.
// These are conditions on signs of polynomials in t, which somewhere.hpp decides.
#pragma once
#include <array>

#include "tamis/contact.hpp"

namespace tamis::oracle {

/// Four points at t=0 and at t=1. vf: the point, then a, b, c. ee: a0, a1, b0, b1. ve: the point, then a, b. vv: two
/// points. Points that a kind does not use are ignored.
struct Motion {
  std::array<Point, 4> start, end;
};

/// A part of the step: [from, to], or [from, to) if half open.
struct Times {
  double from = 0;
  double to = 1;
  bool half_open = false;
};

/// Do the closed features share a point at some of these times?
bool touches(PairKind kind, const Motion& motion, const Times& times = {});

/// Is the Euclidean distance of the closed features <= separation at some of these times?
bool comes_within(PairKind kind, const Motion& motion, double separation, const Times& times = {});

/// comes_within without the sampled distances that answer most questions: for the test of sampling.
bool comes_within_by_algebra(PairKind kind, const Motion& motion, double separation, const Times& times = {});

enum class Always { no, yes, unknown };
/// Is the distance <= separation at all of these times? Samples times: a distance grows no faster than the corners
/// move, so a sample bounds the distance at the times around it. Unknown if it comes too near to the separation.
Always stays_within(PairKind kind, const Motion& motion, double separation, const Times& times);

}  // namespace tamis::oracle
