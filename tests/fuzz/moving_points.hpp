// Moving points out of a fuzzer's bytes, such that few bytes make the special positions in which contacts are lost.
#pragma once
#include <vector>

#include "fuzz/byte_source.hpp"
#include "tamis/step.hpp"

namespace tamis::fuzz {

struct MovingPoints {
  std::vector<Point> start, end;
};

/// Every point is, at either end of the step, at rest, on an earlier point, on the line through two of them, some units
/// in the last place beside one, or anywhere: on small integers, on dyadic numbers, on any double. All are finite.
MovingPoints take_points(ByteSource& bytes, std::size_t count);

/// Another unit of length (a power of two) and another origin, as the bytes say; mostly none. What would overflow
/// stays.
void place(ByteSource& bytes, MovingPoints& points);

}  // namespace tamis::fuzz
