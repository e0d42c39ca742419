// The stages in lanes over one buffer of pairs, and how their results are read.
#pragma once
#include <algorithm>
#include <span>

#include "numbers/in_parts.hpp"
#include "search/engine/workspace.hpp"
#include "search/query/isolated.hpp"
#include "search/query/pair_vertices.hpp"

namespace tamis {

/// Decides which pairs of thread.boxes touch: slab clip, DNF and NCF, roots in lanes. Returns how many entries of
/// thread.solved there are, pairs that touch or are undecided; each names its place in thread.filtered. `stages`: of
/// the kind, or along_edges.
int decide_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages);

/// The same without roots: pairs that the filters leave are in thread.filtered.
void filter_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages);

/// Decides which pairs come within their separation until `latest`: slab clip, axes that turn, advancement in lanes.
/// Results as of decide_crossings().
int decide_within_separation(SearchThread& thread, PairKind kind, double latest);

/// Calls add(place, PairResult) for each pair that touches, and returns the places of those that are undecided, in
/// thread.undecided. REQUIRES: the first `count` entries of thread.solved name pairs of thread.filtered.
template <class Add>
std::span<const int> add_solved(SearchThread& thread, int count, const Add& add) {
  TAMIS_ASSERT(0 <= count && count <= thread.filtered.count);
  thread.undecided.clear();
  for (int i = 0; i < count; ++i) {
    const SolvedPair& s = thread.solved[static_cast<std::size_t>(i)];
    if (s.is_decided)
      add(s.pair, s.result);
    else
      thread.undecided.push_back(s.pair);
  }
  thread.counts.decided_by.lanes += static_cast<std::uint64_t>(thread.filtered.count) - thread.undecided.size();
  return thread.undecided;
}

/// Calls add(place, DecidedPair) for the pairs at these places of thread.filtered that wants(place), each decided by
/// decide(place, counts). Threads that have nothing else to do share them, as a pair takes a microsecond or a hundred.
/// If not `all` are wanted, a decided pair may spare the next ones: first one pair is decided, then two, and so on.
template <class Wants, class Decide, class Add>
void decide_singly(SearchThread& thread, std::span<const int> places, bool all, const Wants& wants,
                   const Decide& decide, const Add& add) {
  constexpr std::size_t kGrain = 16;
  const auto decide_part = [&](std::size_t begin, std::size_t end) {
    PrecisionCount counts;
    for (; begin != end; ++begin) {
      const std::uint64_t by_integers = counts.exact;
      const PairResult result = wants(places[begin]) ? decide(places[begin], counts) : PairResult{};
      thread.decided[begin] = {result, counts.exact > by_integers};
    }
    return counts;
  };
  thread.decided.resize(places.size());
  for (std::size_t begin = 0, count = all ? places.size() : 1; begin < places.size(); begin += count, count *= 2) {
    const std::size_t end = std::min(begin + count, places.size());
    isolated([&] {  // a thread that waits here must not begin another part of the search, which would use its buffers
      const auto sum = [](PrecisionCount a, const PrecisionCount& b) { return a += b; };
      thread.counts.decided_by += joined_parts(end - begin, kGrain, PrecisionCount(), sum, [&](auto from, auto until) {
        return decide_part(begin + from, begin + until);
      });
    });
    for (std::size_t i = begin; i < end; ++i) add(places[i], thread.decided[i]);
  }
}

}  // namespace tamis
