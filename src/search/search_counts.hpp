// What a question has cost: pairs that entered each stage, and where the time went.
#pragma once
#include <initializer_list>

#include "query/stage_counts.hpp"

namespace tamis {

/// Of one thread, or of all.
struct SearchCounts {
  StageCount boxes{"boxes"}, slab{"slab"}, apart{"apart"}, near{"near"}, dnf{"dnf"}, ncf{"ncf"}, solve{"solve"};
  PrecisionCount decided_by;
  std::uint64_t nodes_visited = 0;
  double traverse = 0, filter = 0, solving = 0;  ///< seconds

  SearchCounts& operator+=(const SearchCounts& other);
  /// Adds to what earlier passes cost. `wall`: seconds of the whole pass, shared out in proportion. `stages`: those
  /// that the question has, in order.
  void add_to(Statistics& statistics, double wall, std::initializer_list<StageCount SearchCounts::*> stages) const;
};

}  // namespace tamis
