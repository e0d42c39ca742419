// The cost of a detector's last question.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "tamis/options.hpp"

namespace tamis {

/// How many pairs of each kind enter one stage of the pipeline.
struct StageCount {
  std::string_view name;
  std::uint64_t vf = 0;
  std::uint64_t ee = 0;
  std::uint64_t ve = 0;
  std::uint64_t vv = 0;
};

/// Wall-clock seconds of each part. `traverse`, `filter` and `solve` share one pass over the tree. Its time is divided
/// in proportion to their sums over the threads. `build` includes listing pairs ahead.
struct Seconds {
  double bounds = 0;
  double build = 0;
  double traverse = 0;
  double filter = 0;
  double solve = 0;
  double total = 0;

  Seconds& operator+=(const Seconds& other) {
    bounds += other.bounds;
    build += other.build;
    traverse += other.traverse;
    filter += other.filter;
    solve += other.solve;
    total += other.total;
    return *this;
  }
};

/// How many pairs each arithmetic decides.
struct PrecisionCount {
  std::uint64_t lanes = 0;       ///< SIMD doubles with error bounds
  std::uint64_t scalar = 0;      ///< one pair alone: subdivision in time, doubles with error bounds, or double-double
  std::uint64_t exact = 0;       ///< exact algebra
  std::uint64_t unresolved = 0;  ///< by none: unresolved contacts, on curved motion only

  PrecisionCount& operator+=(const PrecisionCount& other) {
    lanes += other.lanes;
    scalar += other.scalar;
    exact += other.exact;
    unresolved += other.unresolved;
    return *this;
  }
};

struct Statistics {
  Isa isa = Isa::baseline;  ///< the one that ran, never `best`
  int threads = 1;
  /// In pipeline order. The first stage counts the pairs of features whose boxes meet. It counts some more pairs, which
  /// depend on earlier questions. If pairs were listed ahead, it counts the pairs of that list that the question
  /// decides.
  std::vector<StageCount> stages;
  PrecisionCount decided_by;
  Seconds seconds;
  /// With AtStart::ignore, the number of pairs that touch at t=0 and do not touch again once they are apart. `contacts`
  /// counts all such pairs; `earliest` and `is_free` count those that they look at. On steps and on paths.
  std::uint64_t ignored = 0;
  std::uint64_t nodes_visited = 0;  ///< nodes of the trees, also to list pairs ahead; 0 if pairs had been listed
  bool rebuilt = false;             ///< the hierarchy was built, not refitted
  /// Memory that the detector holds: hierarchy, buffers, contacts, groups, rings. With more than one thread it differs
  /// from run to run. Each thread's buffers grow with that thread's share of the work.
  std::uint64_t memory_bytes = 0;
};

}  // namespace tamis
