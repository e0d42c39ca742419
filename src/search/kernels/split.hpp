// Splits the centers of features in two along their longest axis, in lanes, without branches on coordinates.
#pragma once
#include "numbers/assert.hpp"
#include "search/bvh/spatial_order.hpp"
#include "search/kernels/rank.hpp"

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

/// `lanes` numbers, then zeros.
template <class T>
inline xsimd::batch<T, Arch> load_some(const T* at, int lanes) {
  if (lanes == kFloatLanes) return xsimd::batch<T, Arch>::load_unaligned(at);
  T padded[kFloatLanes] = {};
  for (int i = 0; i < lanes; ++i) padded[i] = at[i];
  return xsimd::batch<T, Arch>::load_unaligned(padded);
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
    const unsigned high = ~low & first_lanes(lanes, kFloatLanes);
    const auto put_all = [&](const auto& put) {
      for (int axis = 0; axis < axes; ++axis) put(centers_.at[axis], scratch_.at[axis]);
      put(centers_.feature, scratch_.feature);
    };
    // No batch may reach beyond place count_ of the scratch: the memory there belongs to another partition.
    if (lanes == kFloatLanes && high_ + kFloatLanes <= count_) {
      put_all([&](auto* centers, auto* scratch) {
        store_partitioned(low, load_some(centers + first, kFloatLanes), centers + low_, scratch + high_);
      });
    } else {
      put_all([&](auto* centers, auto* scratch) {
        const auto some = load_some(centers + first, lanes);
        store_compressed_only(low, some, centers + low_);
        store_compressed_only(high, some, scratch + high_);
      });
    }
    const int lows = count_bits(low);
    low_ += static_cast<std::size_t>(lows);
    high_ += static_cast<std::size_t>(lanes - lows);
  }
  std::size_t lows() const { return low_; }

 private:
  const Centers centers_, scratch_;
  const std::size_t count_;
  std::size_t low_ = 0, high_;  ///< where the next ones go
};

template <int axes>
void partition_at(const Cut& cut, const float* along, const Centers& centers, const Centers& scratch, std::size_t count,
                  std::size_t lower) {
  Partition<axes> parts(centers, scratch, count, lower);
  const FloatLanes pivot(cut.at);
  std::size_t equal = lower - cut.below;  // so many numbers equal to the cut, the first ones, are low
  for (std::size_t first = 0; first < count; first += kFloatLanes) {
    const int lanes = count - first < kFloatLanes ? static_cast<int>(count - first) : kFloatLanes;
    const unsigned in_use = first_lanes(lanes, kFloatLanes);
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
