// Splitting the centers of features in two along their longest axis: a selection, sixteen at a time and without
// branches on coordinates (Floyd, Rivest 1975: pivots from a sample, a little beyond the place looked for).
#pragma once
#include "kernels/partition.hpp"

namespace tamis::TAMIS_ISA {

/// Largest less smallest of `count` numbers.
inline float extent(const float* at, std::size_t count) {
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
  float lows[kFloatLanes], highs[kFloatLanes];
  low.store_unaligned(lows);
  high.store_unaligned(highs);
  for (int k = 1; k < kFloatLanes; ++k) {
    lows[0] = lows[k] < lows[0] ? lows[k] : lows[0];
    highs[0] = highs[k] > highs[0] ? highs[k] : highs[0];
  }
  return highs[0] - lows[0];
}

template <int axes>
int longest_axis(const Centers& centers, std::size_t count) {
  int longest = 0;
  float most = extent(centers.at[0], count);
  for (int axis = 1; axis < axes; ++axis) {
    const float here = extent(centers.at[axis], count);
    longest = here > most ? axis : longest;
    most = here > most ? here : most;
  }
  return longest;
}

/// A number of which `wanted` of `count` are likely to be on the nearer side of it, with few others.
inline float pivot_near(const float* at, std::size_t count, std::size_t wanted) {
  constexpr int kSample = 32, kBeyond = 2;
  const auto sample = [&](int i) { return at[static_cast<std::size_t>(i) * count / kSample]; };
  const Ranks ranks(kSample, sample);
  const int rank = static_cast<int>(wanted * kSample / count);
  const int beyond = rank < kSample / 2 + 1 ? rank + kBeyond : rank - kBeyond;
  return sample(ranks.place_of(beyond));
}

/// `lanes` numbers, then zeros.
inline FloatLanes load_some(const float* at, int lanes) {
  if (lanes == kFloatLanes) return FloatLanes::load_unaligned(at);
  float padded[kFloatLanes] = {};
  for (int i = 0; i < lanes; ++i) padded[i] = at[i];
  return FloatLanes::load_unaligned(padded);
}

template <int axes>
void split_along_longest(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower) {
  const float* const at = centers.at[longest_axis<axes>(centers, count)];
  std::size_t begin = 0, end = count;  // the place looked for is between them
  const auto part = [&](const auto& low_lanes) {
    Partition<axes> parts(centers.from(begin), scratch.from(begin));
    for (std::size_t first = begin; first < end; first += kFloatLanes) {
      const int lanes = end - first < kFloatLanes ? static_cast<int>(end - first) : kFloatLanes;
      parts.take(first - begin, low_lanes(first, lanes), lanes);
    }
    return begin + parts.finish();
  };
  while (end - begin > Ranks::kRanked) {
    const FloatLanes pivot(pivot_near(at + begin, end - begin, lower - begin));
    std::size_t middle = part([&](std::size_t i, int lanes) { return bits(load_some(at + i, lanes) < pivot); });
    if (middle == begin)
      middle = part([&](std::size_t i, int lanes) { return bits(load_some(at + i, lanes) <= pivot); });
    if (middle == end) return;  // all the same
    (lower < middle ? end : begin) = middle;
    if (lower == begin) return;
  }
  const Ranks ranks(static_cast<int>(end - begin), [&](int i) { return at[begin + static_cast<std::size_t>(i)]; });
  part([&](std::size_t i, int) { return ranks.below(static_cast<int>(lower - begin), static_cast<int>(i - begin)); });
}

inline void split(const Centers& centers, const Centers& scratch, std::size_t count, std::size_t lower) {
  const auto part = centers.axes == 3 ? split_along_longest<3> : split_along_longest<6>;
  part(centers, scratch, count, lower);
}

}  // namespace tamis::TAMIS_ISA
