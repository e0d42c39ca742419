// find_crossing for many pairs, two batches of lanes at a time.
#pragma once
#include <optional>

#include "numbers/lanes.hpp"
#include "pair/narrow/crossing.hpp"

namespace tamis::TAMIS_ISA {

/// The arguments of find_crossing for as many pairs as there are lanes.
struct CrossingBatch {
  int first;       ///< place of the first pair
  unsigned lanes;  ///< bits of the lanes whose pairs are asked about
  PairMotion<DoubleLanes> motion;
  TimeInterval<DoubleLanes> part;
};

/// Finds the crossings of the pairs 0 to `count`, batch by batch. make(first) returns the batch of the pairs first,
/// first + 1, ..., a CrossingBatch or a class derived from it; keep(batch, crossings) takes its crossings. A batch
/// whose `lanes` is 0 is skipped.
template <PairKind kind, class Make, class Keep>
inline void for_each_crossing(int count, const Make& make, const Keep& keep) {
  std::optional<decltype(make(0))> waiting;
  for (int first = 0; first < count; first += kDoubleLanes) {
    const auto batch = make(first);
    if (!batch.lanes) continue;
    if (!waiting) {
      waiting.emplace(batch);
      continue;
    }
    const auto crossings = find_two_crossings<kind>(waiting->motion, waiting->part, batch.motion, batch.part);
    keep(*waiting, crossings[0]);
    keep(batch, crossings[1]);
    waiting.reset();
  }
  if (waiting) keep(*waiting, find_crossing<kind>(waiting->motion, waiting->part));
}

}  // namespace tamis::TAMIS_ISA
