// Pairs of features, as many as there are, as a PairBuffer has them: the vertices of their corners, and the part of a
// step in which they may touch.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "motion/time_clip.hpp"

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
  std::uint64_t memory_bytes() const;

 private:
  static constexpr std::size_t kCorners = 4;
  std::array<std::vector<std::int32_t>, kCorners> corner_;  ///< those that the kind has not are empty
  std::vector<float> t_in_, t_out_;
};

inline bool any_of(std::span<const PairList> lists) {
  return std::any_of(lists.begin(), lists.end(), [](const PairList& list) { return list.size() > 0; });
}

}  // namespace tamis
