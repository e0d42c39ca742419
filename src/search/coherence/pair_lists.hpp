// Lists of any length of pairs of features. Each pair has the part of a step when it may touch.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/kernels/kernels.hpp"

namespace tamis {

struct Candidate {
  std::array<Index, 4> corners;  ///< as in PairBuffer
  TimeInterval<float> time;      ///< when the pair may touch
};

/// Grows in parts that never move. Adding a pair, or taking a list, copies no pairs that are there already.
class PairList {
 public:
  bool empty() const;
  /// The number of parts, of at most 1024 pairs each.
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

/// Appends to `pairs` each of `listed` that may touch at some time of `when`. In `pairs` their times are [0, t_limit].
/// REQUIRES: room for all of them, times in order.
void append(std::span<const Candidate> listed, const TimeInterval<float>& when, float t_limit, PairBuffer& pairs);

/// One list of each kind.
class PairLists {
 public:
  PairList& operator[](PairKind kind) { return lists_[static_cast<std::size_t>(kind)]; }
  const PairList& operator[](PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  /// True if there is any pair.
  bool any() const;
  /// Moves all pairs of `other` here.
  void take(PairLists& other);
  void clear();
  std::uint64_t memory_bytes() const { return held_bytes(lists_); }

 private:
  std::array<PairList, kPairKinds> lists_;
};

}  // namespace tamis
