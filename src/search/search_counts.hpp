// What a question has cost: pairs that entered each stage, and where the time went.
#pragma once
#include <initializer_list>

#include "coherence/pairs_ahead.hpp"
#include "query/stage_counts.hpp"

namespace tamis {

/// Of one thread, or of all.
struct SearchCounts {
  StageCount boxes{"boxes"}, slab{"slab"}, apart{"apart"}, near{"near"}, dnf{"dnf"}, ncf{"ncf"}, solve{"solve"};
  PrecisionCount decided_by;
  std::uint64_t nodes_visited = 0;
  double traverse = 0, filter = 0, solving = 0;  ///< seconds

  /// With the refit of so many leaf blocks. The unit is what a pair takes whose boxes meet; the others were measured
  /// (docs/history/performance.md, "Lists that cost too much"), and decide on time alone.
  SearchWork work(int leaf_blocks) const {
    constexpr std::uint64_t kRefitOfBlock = 12, kNode = 5, kClippedPair = 9;
    return {kRefitOfBlock * static_cast<std::uint64_t>(leaf_blocks) + kNode * nodes_visited,
            total(boxes) + kClippedPair * (total(dnf) + total(apart))};
  }
  SearchCounts& operator+=(const SearchCounts& other);
  /// Adds to what earlier passes cost. `wall`: seconds of the whole pass, shared out in proportion. `stages`: those
  /// that the question has, in order.
  void add_to(Statistics& statistics, double wall, std::initializer_list<StageCount SearchCounts::*> stages) const;
};

}  // namespace tamis
