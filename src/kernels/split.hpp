// Splitting the centers of features in two along their longest axis: a selection, sixteen at a time and without
// branches on coordinates (Floyd, Rivest 1975: pivots from a sample, a little beyond the place looked for).
#pragma once
#include "bvh/spatial_order.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

inline int longest_axis(const Centers& centers, std::size_t count) {
  float size[3];
  for (int axis = 0; axis < 3; ++axis) {
    const float* at = centers.at[axis];
    FloatLanes low(at[0]), high(at[0]);
    std::size_t i = 0;
    for (; i + kFloatLanes <= count; i += kFloatLanes) {
      const auto x = FloatLanes::load_unaligned(at + i);
      low = min(low, x);
      high = max(high, x);
    }
    float l[kFloatLanes], h[kFloatLanes];
    low.store_unaligned(l);
    high.store_unaligned(h);
    for (; i < count; ++i) l[0] = at[i] < l[0] ? at[i] : l[0], h[0] = at[i] > h[0] ? at[i] : h[0];
    for (int k = 1; k < kFloatLanes; ++k) l[0] = l[k] < l[0] ? l[k] : l[0], h[0] = h[k] > h[0] ? h[k] : h[0];
    size[axis] = h[0] - l[0];
  }
  const int yz = size[2] > size[1] ? 2 : 1;
  return size[yz] > size[0] ? yz : 0;
}

/// Moves lanes between arrays that are one behind the other: the low ones within `items`, the high ones to `scratch`.
class Partition {
 public:
  Partition(const Centers& items, const Centers& scratch) : items_(items), scratch_(scratch) {}

  /// `low`: bits of the low ones of the lanes that start at `first`, `count` of them in use. To be called in order.
  void take(std::size_t first, unsigned low, int count) {
    const unsigned used = static_cast<unsigned>((std::uint64_t{1} << count) - 1);
    FloatLanes at[3];
    IntLanes feature;
    if (count == kFloatLanes) {
      for (int axis = 0; axis < 3; ++axis) at[axis] = FloatLanes::load_unaligned(items_.at[axis] + first);
      feature = IntLanes::load_unaligned(items_.feature + first);
      put(low & used, at, feature, items_.from(low_count_));
      put(~low & used, at, feature, scratch_.from(high_count_));
    } else {
      put_singly(first, low, count);
      return;
    }
    low_count_ += static_cast<std::size_t>(__builtin_popcount(low & used));
    high_count_ += static_cast<std::size_t>(__builtin_popcount(~low & used));
  }

  /// Returns the number of low ones.
  std::size_t finish() {
    const Centers to = items_.from(low_count_);
    for (int axis = 0; axis < 3; ++axis) __builtin_memcpy(to.at[axis], scratch_.at[axis], high_count_ * sizeof(float));
    __builtin_memcpy(to.feature, scratch_.feature, high_count_ * sizeof(Index));
    return low_count_;
  }

 private:
  static void put(unsigned mask, const FloatLanes (&at)[3], const IntLanes& feature, const Centers& to) {
    for (int axis = 0; axis < 3; ++axis) store_compressed(mask, at[axis], to.at[axis]);
    store_compressed(mask, feature, to.feature);
  }

  /// Fewer than a batch: nothing behind them may be overwritten.
  void put_singly(std::size_t first, unsigned low, int count) {
    for (int i = 0; i < count; ++i) {
      const std::size_t is_low = low >> i & 1, from = first + static_cast<std::size_t>(i);
      const Centers to = is_low ? items_.from(low_count_) : scratch_.from(high_count_);
      for (int axis = 0; axis < 3; ++axis) *to.at[axis] = items_.at[axis][from];
      *to.feature = items_.feature[from];
      low_count_ += is_low;
      high_count_ += 1 - is_low;
    }
  }

  const Centers items_, scratch_;
  std::size_t low_count_ = 0, high_count_ = 0;
};

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

/// A number of which `wanted` of `count` are likely to be on the nearer side of it, with few others.
inline float pivot_near(const float* at, std::size_t count, std::size_t wanted) {
  constexpr int kSample = 32, kBeyond = 2;
  const auto sample = [&](int i) { return at[static_cast<std::size_t>(i) * count / kSample]; };
  const Ranks ranks(kSample, sample);
  const int rank = static_cast<int>(wanted * kSample / count);
  const int beyond = rank < kSample / 2 + 1 ? rank + kBeyond : rank - kBeyond;
  return sample(ranks.place_of(beyond));
}

/// Calls `take(first, lanes)` for each batch of `count` items.
template <class Take>
inline void for_each_batch(std::size_t count, const Take& take) {
  std::size_t first = 0;
  for (; first + kFloatLanes <= count; first += kFloatLanes) take(first, kFloatLanes);
  if (first < count) take(first, static_cast<int>(count - first));
}

inline void split(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower) {
  const int axis = longest_axis(centers, count);
  std::size_t begin = 0, end = count;
  while (end - begin > Ranks::kRanked) {
    const Centers items = centers.from(begin);
    const float pivot = pivot_near(items.at[axis], end - begin, lower - begin);
    const auto partition = [&](const auto& is_low) {
      Partition parts(items, scratch.from(begin));
      for_each_batch(end - begin, [&](std::size_t first, int lanes) {
        float padded[kFloatLanes] = {};
        const float* at = items.at[axis] + first;
        if (lanes < kFloatLanes) {
          for (int i = 0; i < lanes; ++i) padded[i] = at[i];
          at = padded;
        }
        parts.take(first, bits(is_low(FloatLanes::load_unaligned(at))), lanes);
      });
      return begin + parts.finish();
    };
    std::size_t middle = partition([&](const FloatLanes& x) { return x < FloatLanes(pivot); });
    if (middle == begin) middle = partition([&](const FloatLanes& x) { return x <= FloatLanes(pivot); });
    if (middle == end) return;  // all the same
    (lower < middle ? end : begin) = middle;
    if (lower == begin) return;
  }
  const Centers items = centers.from(begin);
  const Ranks ranks(static_cast<int>(end - begin), [&](int i) { return items.at[axis][i]; });
  Partition parts(items, scratch.from(begin));
  for_each_batch(end - begin, [&](std::size_t first, int lanes) {
    parts.take(first, ranks.below(static_cast<int>(lower - begin), static_cast<int>(first)), lanes);
  });
  parts.finish();
}

}  // namespace tamis::TAMIS_ISA
