// Lists of pairs of features of any length, with the part of a step in which each pair may touch.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "motion/time_clip.hpp"
#include "numerics/held_bytes.hpp"

namespace tamis {

struct Candidate {
  std::array<Index, 4> corners;  ///< as in PairBuffer
  TimeInterval<float> time;      ///< it may touch
};

/// Appends the pairs of a buffer to a list.
void append(const PairBuffer& pairs, std::vector<Candidate>& list);

/// Appends to `pairs` those of `listed` that may touch at some time of `when`; there their times are [0, t_limit].
/// REQUIRES: room for all of them, times in order.
void append(std::span<const Candidate> listed, const TimeInterval<float>& when, float t_limit, PairBuffer& pairs);

/// One list of each kind.
class PairLists {
 public:
  std::vector<Candidate>& operator[](PairKind kind) { return lists_[static_cast<std::size_t>(kind)]; }
  const std::vector<Candidate>& operator[](PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  /// Is there any pair?
  bool any() const;
  /// Moves all pairs of `other` here.
  void take(PairLists& other);
  /// Keeps the memory.
  void clear();
  std::uint64_t memory_bytes() const { return held_bytes(lists_); }

 private:
  std::array<std::vector<Candidate>, kPairKinds> lists_;
};

}  // namespace tamis
