// The two parts of a selection in lanes: ranking a few numbers, and moving items apart.
#pragma once
#include "bvh/spatial_order.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// Up to kRanked numbers, and how many of them each exceeds; equal ones in their order.
class Ranks {
 public:
  static constexpr int kRanked = 64;

  /// `number(i)` is within [-8, 8].
  template <class Number>
  Ranks(int count, const Number& number) : count_((count + kFloatLanes - 1) / kFloatLanes * kFloatLanes) {
    for (int i = 0; i < count_; ++i) {
      // Positive floats are ordered as their bits are; the last six make each number unique.
      const float positive = i < count ? number(i) + 16.0f : 32.0f;
      keys_[i] = (__builtin_bit_cast(std::int32_t, positive) & ~(kRanked - 1)) | i;
    }
    for (int first = 0; first < count_; first += kFloatLanes) {
      const auto keys = IntLanes::load_aligned(keys_ + first);
      IntLanes rank(0);
      for (int i = 0; i < count_; ++i) rank = select(IntLanes(keys_[i]) < keys, rank + IntLanes(1), rank);
      rank.store_aligned(ranks_ + first);
    }
  }

  unsigned below(int rank, int first) const { return bits(IntLanes::load_aligned(ranks_ + first) < IntLanes(rank)); }
  /// The place of the number with this rank.
  int place_of(int rank) const {
    for (int first = 0;; first += kFloatLanes)
      if (const unsigned found = bits(IntLanes::load_aligned(ranks_ + first) == IntLanes(rank)))
        return first + __builtin_ctz(found);
  }

 private:
  const int count_;
  alignas(64) std::int32_t keys_[kRanked], ranks_[kRanked];
};

/// Of centers that have so many axes. Moves lanes between arrays that are one behind the other: the low ones within
/// `items`, the high ones to `scratch`.
template <int axes>
class Partition {
 public:
  Partition(const Centers& items, const Centers& scratch) : items_(items), scratch_(scratch) {}

  /// `low`: bits of the low ones of the lanes that start at `first`, `count` of them in use. To be called in order.
  void take(std::size_t first, unsigned low, int count) {
    if (count < kFloatLanes) return put_singly(first, low, count);
    constexpr unsigned kAll = (1u << kFloatLanes) - 1;
    FloatLanes at[axes];
    for (int axis = 0; axis < axes; ++axis) at[axis] = FloatLanes::load_unaligned(items_.at[axis] + first);
    const auto feature = IntLanes::load_unaligned(items_.feature + first);
    put(low & kAll, at, feature, items_, low_count_);
    put(~low & kAll, at, feature, scratch_, high_count_);
    low_count_ += static_cast<std::size_t>(__builtin_popcount(low & kAll));
    high_count_ += static_cast<std::size_t>(__builtin_popcount(~low & kAll));
  }

  /// Puts the high ones behind the low ones; returns the number of these.
  std::size_t finish() {
    for (int axis = 0; axis < axes; ++axis)
      __builtin_memcpy(items_.at[axis] + low_count_, scratch_.at[axis], high_count_ * sizeof(float));
    __builtin_memcpy(items_.feature + low_count_, scratch_.feature, high_count_ * sizeof(Index));
    return low_count_;
  }

 private:
  static void put(unsigned mask, const FloatLanes (&at)[axes], const IntLanes& feature, const Centers& to,
                  std::size_t first) {
    for (int axis = 0; axis < axes; ++axis) store_compressed(mask, at[axis], to.at[axis] + first);
    store_compressed(mask, feature, to.feature + first);
  }

  /// Fewer than a batch: nothing behind them may be overwritten.
  void put_singly(std::size_t first, unsigned low, int count) {
    for (int i = 0; i < count; ++i) {
      const std::size_t is_low = low >> i & 1, from = first + static_cast<std::size_t>(i);
      const Centers& to = is_low ? items_ : scratch_;
      const std::size_t place = is_low ? low_count_ : high_count_;
      for (int axis = 0; axis < axes; ++axis) to.at[axis][place] = items_.at[axis][from];
      to.feature[place] = items_.feature[from];
      low_count_ += is_low;
      high_count_ += 1 - is_low;
    }
  }

  const Centers items_, scratch_;
  std::size_t low_count_ = 0, high_count_ = 0;
};

}  // namespace tamis::TAMIS_ISA
