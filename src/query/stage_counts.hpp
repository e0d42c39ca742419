// Counts of pairs, by kind; sums of what several questions cost.
#pragma once
#include <algorithm>
#include <iterator>

#include "motion/pair_kinds.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

inline std::uint64_t& of(StageCount& count, PairKind kind) {
  std::uint64_t* const counts[] = {&count.vf, &count.ee, &count.ve, &count.vv};
  static_assert(std::size(counts) == kPairKinds);
  return *counts[static_cast<std::size_t>(kind)];
}

inline std::uint64_t total(const StageCount& count) { return count.vf + count.ee + count.ve + count.vv; }

inline void add(StageCount& to, const StageCount& from) {
  to.vf += from.vf;
  to.ee += from.ee;
  to.ve += from.ve;
  to.vv += from.vv;
}

/// To the stage of its name; a new one is the last.
inline void add(std::vector<StageCount>& to, const StageCount& from) {
  const auto same = std::ranges::find(to, from.name, &StageCount::name);
  if (same == to.end())
    to.push_back(from);
  else
    add(*same, from);
}

}  // namespace tamis
