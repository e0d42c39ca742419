// What a question has cost: pairs that entered each stage, and where the time went.
#pragma once
#include <initializer_list>

#include "search/coherence/kept_lists.hpp"
#include "search/query/stage_counts.hpp"

namespace tamis {

/// Of one thread, or of all.
struct SearchCounts {
  StageCount boxes{"boxes"}, slab{"slab"}, apart{"apart"}, near{"near"}, dnf{"dnf"}, ncf{"ncf"}, solve{"solve"};
  PrecisionCount decided_by;
  std::uint64_t nodes_visited = 0;
  double traverse = 0, filter = 0, solving = 0;  ///< seconds

  /// The work of the search and of refitting so many leaf blocks, in units of a pair whose boxes meet. The weights were
  /// measured (docs/history/performance.md, "Lists that cost too much"); no answer depends on them.
  SearchWork work(int leaf_blocks) const {
    constexpr std::uint64_t kRefitOfBlock = 12, kNode = 5, kClippedPair = 9;
    return {kRefitOfBlock * static_cast<std::uint64_t>(leaf_blocks) + kNode * nodes_visited,
            total(boxes) + kClippedPair * (total(dnf) + total(apart))};
  }
  SearchCounts& operator+=(const SearchCounts& other);
  /// Adds the counts to `statistics`, beside those of earlier passes. `wall`: wall-clock seconds of this pass, which
  /// are shared out in proportion. `stages`: those of the question, in order.
  void add_to(Statistics& statistics, double wall, std::initializer_list<StageCount SearchCounts::*> stages) const;
};

}  // namespace tamis
