// Lists of pairs of features of any length, with the data of a PairBuffer: the vertices of their corners, and the part
// of a step in which they may touch.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "kernels/kernels.hpp"
#include "motion/time_clip.hpp"
#include "numerics/held_bytes.hpp"

namespace tamis {

class PairList {
 public:
  std::size_t size() const { return t_in_.size(); }
  void clear();
  /// Appends all pairs of a buffer, which have `corners` vertices each. REQUIRES: as many as the pairs in the list.
  void append(const PairBuffer& pairs, std::size_t corners);
  /// Moves all pairs of `other` here. REQUIRES: the same kind.
  void take(PairList& other);
  /// Appends to `pairs` those of the pairs first to last that may touch at some time of `when`; there their times are
  /// [0, t_limit]. REQUIRES: pairs that there are, space for all of them, times in order.
  void copy(std::size_t first, std::size_t last, const TimeInterval<float>& when, float t_limit,
            PairBuffer& pairs) const;
  std::uint64_t memory_bytes() const { return held_bytes(corner_, t_in_, t_out_); }

 private:
  static constexpr std::size_t kCorners = 4;
  std::array<std::vector<std::int32_t>, kCorners> corner_;  ///< empty for corners that the kind does not have
  std::vector<float> t_in_, t_out_;
};

/// One of each kind.
class PairLists {
 public:
  PairList& operator[](PairKind kind) { return lists_[static_cast<std::size_t>(kind)]; }
  const PairList& operator[](PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  /// Is there any pair?
  bool any() const;
  /// Moves all pairs of `other` here.
  void take(PairLists& other);
  /// Keeps the memory.
  void clear();
  std::uint64_t memory_bytes() const { return held_bytes(lists_); }

 private:
  std::array<PairList, kPairKinds> lists_;
};

}  // namespace tamis
