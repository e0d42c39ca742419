// The crossings of many pairs, two strides of lanes at a time.
#pragma once
#include <optional>

#include "narrow/crossing.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// As many pairs as there are lanes, on their way to find_crossing.
struct CrossingStride {
  int first;       ///< place of the first of them
  unsigned lanes;  ///< bits of those that are asked
  PairMotion<DoubleLanes> motion;
  TimeInterval<DoubleLanes> part;
};

/// make(first) gives what derives from CrossingStride, of the pairs first, first + 1, ... up to `count`; its crossings
/// go to keep(stride, crossings), unless no lane of it is asked.
template <PairKind kind, class Make, class Keep>
inline void for_each_crossing(int count, const Make& make, const Keep& keep) {
  using Stride = decltype(make(0));
  struct Made {  // in its place: a stride is too large to copy
    operator Stride() const { return make(first); }
    const Make& make;
    int first;
  };
  std::optional<Stride> waiting, stride;
  for (int first = 0; first < count; first += kDoubleLanes) {
    auto& next = waiting ? stride : waiting;
    if (!next.emplace(Made{make, first}).lanes) {
      next.reset();
      continue;
    }
    if (!stride) continue;
    const auto crossings = find_two_crossings<kind>(waiting->motion, waiting->part, stride->motion, stride->part);
    keep(*waiting, crossings[0]);
    keep(*stride, crossings[1]);
    waiting.reset();
    stride.reset();
  }
  if (waiting) keep(*waiting, find_crossing<kind>(waiting->motion, waiting->part));
}

}  // namespace tamis::TAMIS_ISA
