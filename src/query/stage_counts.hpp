// Counts of pairs, by kind.
#pragma once
#include <iterator>

#include "motion/pair_kinds.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

inline std::uint64_t& of(StageCount& count, PairKind kind) {
  std::uint64_t* const counts[] = {&count.vf, &count.ee, &count.ve, &count.vv};
  static_assert(std::size(counts) == kPairKinds);
  return *counts[static_cast<std::size_t>(kind)];
}

inline void add(StageCount& to, const StageCount& from) {
  to.vf += from.vf;
  to.ee += from.ee;
  to.ve += from.ve;
  to.vv += from.vv;
}

}  // namespace tamis
