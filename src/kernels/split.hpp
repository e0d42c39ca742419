// Splits the centers of features in two along their longest axis, in lanes, without branches on coordinates.
#pragma once
#include "bvh/spatial_order.hpp"
#include "kernels/rank.hpp"
#include "numerics/assert.hpp"

namespace tamis::TAMIS_ISA {

inline NumberRange extent_of(const float* at, std::size_t count) {
  FloatLanes low(at[0]), high(at[0]);
  std::size_t i = 0;
  for (; i + kFloatLanes <= count; i += kFloatLanes) {
    const auto x = FloatLanes::load_unaligned(at + i);
    low = min(low, x);
    high = max(high, x);
  }
  for (; i < count; ++i) {
    low = min(low, FloatLanes(at[i]));
    high = max(high, FloatLanes(at[i]));
  }
  return {least(low), greatest(high)};
}

struct LongestAxis {
  int axis;
  NumberRange extent;
};

/// Measures only axes that may be the longest, by the bounds in `extents`, and enters their lengths there.
inline LongestAxis longest_axis(const Centers& centers, std::size_t count, ExtentBounds& extents) {
  LongestAxis longest{};
  float most = -1;
  for (unsigned measured = 0;;) {
    int next = -1;
    for (int axis = 0; axis < centers.axes; ++axis)
      if (!(measured >> axis & 1) && (next < 0 || extents.along[axis] > extents.along[next])) next = axis;
    if (next < 0 || extents.along[next] <= most) return longest;
    measured |= 1u << next;
    const NumberRange extent = extent_of(centers.at[next], count);
    const float length = extents.along[next] = extent.high - extent.low;
    if (length > most) {
      longest = {next, extent};
      most = length;
    }
  }
}

/// Partitions centers, batch after batch: low ones move forward in place, high ones to `scratch`, from place `lower`
/// on.
template <int axes>
class Partition {
 public:
  Partition(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower)
      : centers_(centers), scratch_(scratch), count_(count), high_(lower) {}

  /// Puts the `lanes` centers from `first` on. `low`: bits of the low ones.
  void take(std::size_t first, unsigned low, int lanes) {
    const int lows = count_bits(low);
    if (lanes < kFloatLanes)
      put_singly(first, low, lanes);
    else
      put(first, low);
    low_ += static_cast<std::size_t>(lows);
    high_ += static_cast<std::size_t>(lanes - lows);
  }
  std::size_t lows() const { return low_; }

 private:
  /// No batch may reach beyond place count_ of the scratch: the memory there belongs to another partition.
  void put(std::size_t first, unsigned low) const {
    constexpr unsigned kAll = (1u << kFloatLanes) - 1;
    const auto feature = IntLanes::load_unaligned(centers_.feature + first);
    if (high_ + kFloatLanes <= count_) {
      for (int axis = 0; axis < axes; ++axis) {
        const auto at = FloatLanes::load_unaligned(centers_.at[axis] + first);
        store_partitioned(low, at, centers_.at[axis] + low_, scratch_.at[axis] + high_);
      }
      store_partitioned(low, feature, centers_.feature + low_, scratch_.feature + high_);
    } else {
      for (int axis = 0; axis < axes; ++axis) {
        const auto at = FloatLanes::load_unaligned(centers_.at[axis] + first);
        store_compressed(low, at, centers_.at[axis] + low_);
        store_compressed_only(~low & kAll, at, scratch_.at[axis] + high_);
      }
      store_compressed(low, feature, centers_.feature + low_);
      store_compressed_only(~low & kAll, feature, scratch_.feature + high_);
    }
  }

  /// For fewer centers than a batch.
  void put_singly(std::size_t first, unsigned low, int lanes) const {
    std::size_t low_place = low_, high_place = high_;
    for (int i = 0; i < lanes; ++i) {
      const bool is_low = low >> i & 1;
      const Centers& to = is_low ? centers_ : scratch_;
      const std::size_t place = is_low ? low_place++ : high_place++, from = first + static_cast<std::size_t>(i);
      for (int axis = 0; axis < axes; ++axis) to.at[axis][place] = centers_.at[axis][from];
      to.feature[place] = centers_.feature[from];
    }
  }

  const Centers centers_, scratch_;
  const std::size_t count_;
  std::size_t low_ = 0, high_;  ///< where the next ones go
};

/// `lanes` numbers, then zeros.
inline FloatLanes load_some(const float* at, int lanes) {
  if (lanes == kFloatLanes) return FloatLanes::load_unaligned(at);
  float padded[kFloatLanes] = {};
  for (int i = 0; i < lanes; ++i) padded[i] = at[i];
  return FloatLanes::load_unaligned(padded);
}

template <int axes>
void partition_at(const Cut& cut, const float* along, const Centers& centers, const Centers& scratch, std::size_t count,
                  std::size_t lower) {
  Partition<axes> parts(centers, scratch, count, lower);
  const FloatLanes pivot(cut.at);
  std::size_t equal = lower - cut.below;  // so many numbers equal to the cut, the first ones, are low
  for (std::size_t first = 0; first < count; first += kFloatLanes) {
    const int lanes = count - first < kFloatLanes ? static_cast<int>(count - first) : kFloatLanes;
    const unsigned in_use = (1u << lanes) - 1;
    const auto x = load_some(along + first, lanes);
    unsigned low = bits(x < pivot) & in_use;
    if (equal > 0)
      for (unsigned at_cut = bits(x == pivot) & in_use; at_cut && equal > 0; at_cut &= at_cut - 1, --equal)
        low |= at_cut & -at_cut;
    parts.take(first, low, lanes);
  }
  TAMIS_ASSERT(parts.lows() == lower);
}

inline HalvesExtents split(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower,
                           ExtentBounds extents) {
  const auto [axis, extent] = longest_axis(centers, count, extents);
  const float* const along = centers.at[axis];
  const Cut cut = cut_at_rank(along, count, lower, extent, scratch.at[0], scratch.at[1]);
  (centers.axes == 3 ? partition_at<3> : partition_at<6>)(cut, along, centers, scratch, count, lower);
  HalvesExtents parts{extents, extents};
  parts.low.along[axis] = cut.at - extent.low;
  parts.high.along[axis] = extent.high - cut.at;
  return parts;
}

}  // namespace tamis::TAMIS_ISA
