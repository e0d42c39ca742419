// Pairs of features, as many as there are, as a PairBuffer has them: the vertices of their corners, and the part of a
// step in which they may touch.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/kernels.hpp"
#include "motion/time_clip.hpp"
#include "numerics/held_bytes.hpp"

namespace tamis {

class PairList {
 public:
  std::size_t size() const { return t_in_.size(); }
  void clear();
  /// All of a buffer; `corners` of a pair. REQUIRES: as many as the pairs that are here have.
  void append(const PairBuffer& pairs, std::size_t corners);
  /// All of `other`, which is empty then. REQUIRES: the same kind.
  void take(PairList& other);
  /// Of the pairs first to last those that may touch at some time of `when` go to `pairs`, whose times are then from 0
  /// to `t_limit`. REQUIRES: pairs that there are, room for all of them, times in order.
  void copy(std::size_t first, std::size_t last, const TimeInterval<float>& when, float t_limit,
            PairBuffer& pairs) const;
  std::uint64_t memory_bytes() const { return held_bytes(corner_, t_in_, t_out_); }

 private:
  static constexpr std::size_t kCorners = 4;
  std::array<std::vector<std::int32_t>, kCorners> corner_;  ///< those that the kind has not are empty
  std::vector<float> t_in_, t_out_;
};

/// One of each kind.
class PairLists {
 public:
  PairList& operator[](PairKind kind) { return lists_[static_cast<std::size_t>(kind)]; }
  const PairList& operator[](PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  /// Is there any pair?
  bool any() const;
  /// All of `other`, which is empty then.
  void take(PairLists& other);
  /// Keeps the memory.
  void clear();
  std::uint64_t memory_bytes() const { return held_bytes(lists_); }

 private:
  std::array<PairList, kPairKinds> lists_;
};

/// After lists that cost more than they saved none are made for a while, each time twice as long.
struct ListingPause {
  static constexpr int kLongest = 64;
  int first, next = first, left = 0;

  void begin() { left = std::exchange(next, std::min(2 * next, kLongest)); }
  void tick() { left = std::max(0, left - 1); }
  void lists_were_worth_it() { next = first; }
};

}  // namespace tamis
