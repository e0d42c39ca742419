// What the last question to a detector cost.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "tamis/options.hpp"

namespace tamis {

/// Pairs that enter a stage of the pipeline.
struct StageCount {
  std::string_view name;
  std::uint64_t vf = 0;
  std::uint64_t ee = 0;
  std::uint64_t ve = 0;
  std::uint64_t vv = 0;
};

/// Wall-clock seconds of each part; with several threads `traverse`, `filter` and `solve` share one pass over the
/// tree, and their parts are scaled from the sums over the threads; `build` includes listing pairs ahead.
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

/// Pairs decided by each arithmetic.
struct PrecisionCount {
  std::uint64_t lanes = 0;       ///< SIMD doubles with error bounds
  std::uint64_t scalar = 0;      ///< subdivision in time, doubles with error bounds, or pairs of doubles
  std::uint64_t exact = 0;       ///< exact algebra
  std::uint64_t unresolved = 0;  ///< none of these: unresolved contacts, of curved motion alone

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
  /// In pipeline order. The first stage counts the pairs of features whose boxes meet, and some more, which depend on
  /// earlier questions (where pairs were listed ahead, those of the list that the question decides).
  std::vector<StageCount> stages;
  PrecisionCount decided_by;
  Seconds seconds;
  /// AtStart::ignore, of contacts, earliest and is_free, of steps and of paths: pairs that touch at t=0, and not again
  /// once they are apart; of the last two those that were looked at.
  std::uint64_t ignored = 0;
  std::uint64_t nodes_visited = 0;  ///< also to list pairs ahead; 0 where they had been
  bool rebuilt = false;             ///< the hierarchy was built, not refitted
  /// Held by the detector: hierarchy, buffers, contacts, groups, rings. With more than one thread it differs from run
  /// to run, as each thread's buffers grow with what that thread came to do.
  std::uint64_t memory_bytes = 0;
};

}  // namespace tamis
