// Pairs of leaf blocks that lie near each other, each with a proven lower bound of how far apart its features are that
// share no vertex: as long as the two blocks have moved against each other by less, none of their features can touch.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/kernels.hpp"

namespace tamis {

/// Bounds, in the unit of the boxes, of how far points of two leaf blocks have moved against each other since drifts
/// are counted, at both ends of the step; what they have in common cancels.
struct RelativeDrift {
  float at_start, at_end;

  RelativeDrift(const TreeView& a, int block, const TreeView& b, int other);
  /// At any time until t: positions are linear in time, so a distance of two of them is convex.
  float until(float t) const;
};

class NearList {
 public:
  /// What a list is made of: trees at t=0 with drifts from there.
  struct Making {
    PairKind kind;
    const Kernels& kernels;
    GapQuestion question;
    float reach;       ///< blocks whose hulls are farther apart are not listed
    float separation;  ///< taken off every gap
    float until;       ///< what moves until then against each other should be covered, kAhead times
  };

  /// Runs in the caller's oneTBB arena.
  void make(const Making& making);
  void clear();
  /// Appends the blocks of b that may touch `block` of a until t; gaps are multiplied by `scale` first.
  void append_unproven(const TreeView& a, const TreeView& b, int block, float t, float scale,
                       std::vector<std::int32_t>& others) const;
  std::size_t size() const { return entries_.size(); }
  std::uint64_t memory_bytes() const {
    return entries_.capacity() * sizeof(Entry) + first_.capacity() * sizeof(std::size_t);
  }

 private:
  struct Entry {
    std::int32_t other;
    float gap;
  };
  using Row = std::vector<Entry>;

  static void measure(const Making& making, int block, PairBuffer& scratch, Row& row);

  std::vector<std::size_t> first_;  ///< of each block of a, and the end
  std::vector<Entry> entries_;
};

}  // namespace tamis
