// Pairs of leaf blocks that lie near each other, each with a proven lower bound of how far apart its features are that
// share no vertex: as long as the two blocks have moved against each other by less, none of their features can touch.
#pragma once
#include <cstdint>
#include <vector>

#include "engines/tamis/block_drifts.hpp"
#include "kernels/kernels.hpp"

namespace tamis {

class NearList {
 public:
  /// What a list is made of: trees at t=0, and the drifts of their blocks from there.
  struct Making {
    PairKind kind;
    const Kernels& kernels;
    GapQuestion question;
    const BlockDrifts &drifts_a, &drifts_b;
    float reach;       ///< blocks whose hulls are farther apart are not listed
    float separation;  ///< taken off every gap
    float until;       ///< what moves until then against each other should be covered, kAhead times
  };

  /// Runs in the caller's oneTBB arena.
  void make(const Making& making);
  void clear();
  /// Appends the blocks of b that may touch `block` of a: of those whose gap is in [from, to), the ones that the drifts
  /// in `scan` do not leave apart.
  void append_unproven(const Kernels& kernels, int block, float from, float to, GapScan scan,
                       std::vector<std::int32_t>& others) const;
  std::size_t size() const { return first_.empty() ? 0 : first_.back(); }
  std::uint64_t memory_bytes() const {
    return others_.capacity() * sizeof(std::int32_t) + gaps_.capacity() * sizeof(float) +
           first_.capacity() * sizeof(std::size_t);
  }

 private:
  struct Entry {
    std::int32_t other;
    float gap;
  };
  using Row = std::vector<Entry>;

  static void measure(const Making& making, int block, PairBuffer& scratch, Row& row);

  std::vector<std::size_t> first_;    ///< of each block of a, and the end
  std::vector<std::int32_t> others_;  ///< a block more than there are: they are read in lanes
  std::vector<float> gaps_;           ///< rising, of each block
};

}  // namespace tamis
