// The cost of a question: pairs that entered each stage, and seconds.
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

  SearchCounts& operator+=(const SearchCounts& other);
  /// Adds the counts to `statistics`, beside earlier passes. `wall`: wall-clock seconds of this pass, shared out in
  /// proportion. `stages`: the question's stages, in order.
  void add_to(Statistics& statistics, double wall, std::initializer_list<StageCount SearchCounts::*> stages) const;
};

}  // namespace tamis
