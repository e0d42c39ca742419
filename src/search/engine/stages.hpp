// The stages over one buffer of pairs: filters and decisions in lanes, then decide() for the pairs that lanes leave.
// Each stage takes a buffer and returns the one that it fills. A returned buffer belongs to the thread, and lasts until
// the thread's next stage.
#pragma once
#include <algorithm>
#include <span>

#include "numbers/in_parts.hpp"
#include "numbers/parallel.hpp"
#include "search/engine/workspace.hpp"

namespace tamis {

/// Slab clip, DNF and NCF: returns the pairs that these leave. `stages`: of the kind, or along_edges.
const PairBuffer& filter_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages,
                                   const PairBuffer& pairs);

/// The same for pairs with a separation: slab clip, then axes that turn with the pair.
const PairBuffer& filter_apart(SearchThread& thread, PairKind kind, const PairKernels& stages, const PairBuffer& pairs);

/// Decides pairs in lanes. Pairs whose contact begins after `latest` count as free.
LaneDecisions decide_in_lanes(SearchThread& thread, const PairKernels& stages, double latest, const PairBuffer& pairs);

/// The pairs that lanes left to decide(): their places in the buffer.
inline std::span<const std::int32_t> undecided(const LaneDecisions& decisions) {
  return {decisions.undecided, static_cast<std::size_t>(decisions.undecided_count)};
}
inline std::span<const TouchingPair> touching(const LaneDecisions& decisions) {
  return {decisions.touching, static_cast<std::size_t>(decisions.touching_count)};
}

/// Calls add(place, DecidedPair) for the pairs at these places that wants(place), each decided by decide(place,
/// counts). Threads that have nothing else to do share them, as a pair takes a microsecond or a hundred. If not `all`
/// are wanted, a decided pair may spare the next ones. So first one pair is decided, then two, and so on.
template <class Wants, class Decide, class Add>
void decide_singly(SearchThread& thread, std::span<const std::int32_t> places, bool all, const Wants& wants,
                   const Decide& decide, const Add& add) {
  constexpr std::size_t kGrain = 16;
  std::vector<DecidedPair>& decided = thread.singly;
  const auto decide_part = [&](std::size_t begin, std::size_t end) {
    PrecisionCount counts;
    for (; begin != end; ++begin) {
      const std::uint64_t by_integers = counts.exact;
      const PairResult result = wants(places[begin]) ? decide(places[begin], counts) : PairResult{};
      decided[begin] = {result, counts.exact > by_integers};
    }
    return counts;
  };
  decided.resize(places.size());
  for (std::size_t begin = 0, count = all ? places.size() : 1; begin < places.size(); begin += count, count *= 2) {
    const std::size_t end = std::min(begin + count, places.size());
    isolated([&] {  // a thread that waits here must not begin another part of the search, which would use its buffers
      const auto sum = [](PrecisionCount a, const PrecisionCount& b) { return a += b; };
      thread.counts.decided_by += joined_parts(end - begin, kGrain, PrecisionCount(), sum, [&](auto from, auto until) {
        return decide_part(begin + from, begin + until);
      });
    });
    for (std::size_t i = begin; i < end; ++i) add(places[i], decided[i]);
  }
}

}  // namespace tamis
