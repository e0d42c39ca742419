// Counts of pairs, by kind; sums of what several questions cost.
#pragma once
#include <algorithm>
#include <iterator>

#include "pair/motion/pair_kinds.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

inline constexpr std::uint64_t StageCount::*kCountOfKind[] = {&StageCount::vf, &StageCount::ee, &StageCount::ve,
                                                              &StageCount::vv};
static_assert(std::size(kCountOfKind) == kPairKinds, "name each kind of pair");

inline std::uint64_t& of(StageCount& count, PairKind kind) {
  return count.*kCountOfKind[static_cast<std::size_t>(kind)];
}

inline std::uint64_t total(const StageCount& count) {
  std::uint64_t sum = 0;
  for (const auto of_kind : kCountOfKind) sum += count.*of_kind;
  return sum;
}

inline void add(StageCount& to, const StageCount& from) {
  for (const auto of_kind : kCountOfKind) to.*of_kind += from.*of_kind;
}

/// Adds to the stage of the same name. A new name becomes the last stage.
inline void add(std::vector<StageCount>& to, const StageCount& from) {
  const auto same = std::ranges::find(to, from.name, &StageCount::name);
  if (same == to.end())
    to.push_back(from);
  else
    add(*same, from);
}

}  // namespace tamis
