// The cost of a detector's last question.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "tamis/options.hpp"

namespace tamis {

/// How many pairs of each kind enter one stage of the pipeline.
struct StageCount {
  std::string_view name;  ///< the stage, such as "boxes"
  std::uint64_t vf = 0;   ///< vertex-face pairs
  std::uint64_t ee = 0;   ///< edge-edge pairs
  std::uint64_t ve = 0;   ///< vertex-edge pairs
  std::uint64_t vv = 0;   ///< vertex-vertex pairs
};

/// Wall-clock seconds of each part. `traverse`, `filter` and `solve` share one pass over the tree. Its time is divided
/// in proportion to their sums over the threads.
struct Seconds {
  double bounds = 0;    ///< computing boxes
  double build = 0;     ///< building or refitting trees, and listing pairs ahead
  double traverse = 0;  ///< searching the trees for pairs whose boxes meet
  double filter = 0;    ///< filtering pairs
  double solve = 0;     ///< deciding the remaining pairs
  double total = 0;     ///< the whole question

  /// Adds each part.
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

  /// Adds each count.
  PrecisionCount& operator+=(const PrecisionCount& other) {
    lanes += other.lanes;
    scalar += other.scalar;
    exact += other.exact;
    unresolved += other.unresolved;
    return *this;
  }
};

/// The cost of one question.
struct Statistics {
  Isa isa = Isa::baseline;  ///< the one that ran, never `best`
  int threads = 1;          ///< how many threads worked on it
  /// In pipeline order. The first stage counts the pairs of features whose boxes meet. It counts some more pairs, which
  /// depend on earlier questions. If pairs were listed ahead, it counts the pairs of that list that the question
  /// decides.
  std::vector<StageCount> stages;
  PrecisionCount decided_by;  ///< how many pairs each arithmetic decided
  Seconds seconds;            ///< wall-clock time
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
