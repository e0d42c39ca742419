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

/// Grows in parts that never move: what is there already costs nothing when a pair is added, or a list taken.
class PairList {
 public:
  bool empty() const;
  /// Of at most 1024 pairs each.
  std::size_t parts() const { return parts_.size(); }
  std::span<const Candidate> part(std::size_t i) const { return parts_[i]; }

  void add(const PairBuffer& pairs);
  /// Moves all pairs of `other` here.
  void take(PairList& other);
  /// Keeps the memory of one part.
  void clear();
  std::uint64_t memory_bytes() const { return held_bytes(parts_); }

 private:
  static constexpr std::size_t kPairsPerPart = 1024;

  std::vector<std::vector<Candidate>> parts_;
};

/// Appends to `pairs` those of `listed` that may touch at some time of `when`; there their times are [0, t_limit].
/// REQUIRES: room for all of them, times in order.
void append(std::span<const Candidate> listed, const TimeInterval<float>& when, float t_limit, PairBuffer& pairs);

/// One list of each kind.
class PairLists {
 public:
  PairList& operator[](PairKind kind) { return lists_[static_cast<std::size_t>(kind)]; }
  const PairList& operator[](PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  /// Is there any pair?
  bool any() const;
  /// Moves all pairs of `other` here.
  void take(PairLists& other);
  void clear();
  std::uint64_t memory_bytes() const { return held_bytes(lists_); }

 private:
  std::array<PairList, kPairKinds> lists_;
};

}  // namespace tamis
