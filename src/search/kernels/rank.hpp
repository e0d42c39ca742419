// Selection: which of many numbers has a given rank? Pivots from a sample, a little beyond the rank, partition the
// numbers until few are left (Floyd, Rivest 1975); interpolation search finds the rank among these.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "search/kernels/compress.hpp"

namespace tamis::TAMIS_ISA {

/// `below` numbers are less than `at`. If these are fewer than `rank`, numbers equal to `at` make up the difference.
struct Cut {
  float at;
  std::size_t below;
};

/// Both ends included.
struct NumberRange {
  float low, high;
};

/// The numbers on both sides of a guess.
struct Sides {
  std::size_t below;  ///< how many numbers are less than it
  float last, first;  ///< the largest of those, the smallest of the others
};

inline Sides sides_of(float guess, const float* numbers, std::size_t count) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  const FloatLanes pivot(guess), none(kNone);
  FloatLanes last = -none, first = none;
  std::size_t i = 0, below = 0;
  for (; i + kFloatLanes <= count; i += kFloatLanes) {
    const auto x = FloatLanes::load_unaligned(numbers + i);
    const auto is_below = x < pivot;
    below += static_cast<std::size_t>(count_bits(bits(is_below)));
    last = max(last, select(is_below, x, -none));
    first = min(first, select(is_below, none, x));
  }
  Sides sides{below, greatest(last), least(first)};
  for (; i < count; ++i) {
    const float x = numbers[i];
    float& nearest = x < guess ? sides.last : sides.first;
    nearest = x < guess ? std::max(nearest, x) : std::min(nearest, x);
    sides.below += x < guess;
  }
  return sides;
}

/// cut_at_rank() for few numbers within `extent`. Every guess excludes at least one of them.
inline Cut cut_few(const float* numbers, std::size_t count, std::size_t rank, NumberRange extent) {
  auto [low, high] = extent;
  std::size_t below_low = 0, below_high = count;
  for (int guesses = 0; low < high; ++guesses) {
    // Guesses alternate: one as if the numbers were spread evenly, one halfway, where they are not.
    const float part = static_cast<float>(rank - below_low) / static_cast<float>(below_high - below_low);
    const float between = low + (high - low) * (guesses % 2 == 0 ? part : 0.5f);
    const float guess = between > low && between < high ? between : high;
    const Sides sides = sides_of(guess, numbers, count);
    if (sides.below == rank) return {guess, rank};
    if (sides.below < rank) {
      low = sides.first;
      below_low = sides.below;
    } else {
      high = sides.last;
      below_high = sides.below;
    }
  }
  return {low, below_low};
}

/// A pivot from the numbers, a little beyond rank `wanted` of `count`, on the side that leaves fewer numbers.
inline float pivot_near(const float* numbers, std::size_t count, std::size_t wanted, NumberRange extent) {
  constexpr std::uint32_t kSample = 32, kBeyond = 2;
  constexpr std::uint32_t kGoldenRatio = 0x9e3779b9;  // of 2^32; equal steps can meet the period of a grid
  float sample[kSample];
  for (std::uint32_t i = 0, place = 0; i < kSample; ++i, place += kGoldenRatio)
    sample[i] = numbers[std::uint64_t{place} * count >> 32];
  const std::size_t rank = wanted * kSample / count;
  return cut_few(sample, kSample, rank <= kSample / 2 ? rank + kBeyond : rank - kBeyond, extent).at;
}

/// Copies the numbers for which is_low(x) to `low`, the others to `high`; both have room for `count`. Either may be
/// `numbers`, which then is overwritten even if no number goes there. Returns how many are low.
template <class IsLow>
std::size_t partition_numbers(const float* numbers, std::size_t count, const IsLow& is_low, float* low, float* high) {
  std::size_t lows = 0, i = 0;
  for (; i + kFloatLanes <= count; i += kFloatLanes) {
    const auto x = FloatLanes::load_unaligned(numbers + i);
    const unsigned mask = bits(is_low(x));
    store_partitioned(mask, x, low + lows, high + (i - lows));
    lows += static_cast<std::size_t>(count_bits(mask));
  }
  for (; i < count; ++i) {
    const float x = numbers[i];
    const bool is = bits(is_low(FloatLanes(x))) & 1;
    (is ? low[lows] : high[i - lows]) = x;
    lows += is;
  }
  return lows;
}

/// The cut at `rank`. `low`, `high`: scratch for `count` numbers each. REQUIRES (not checked: lanes): finite numbers
/// within `extent`; rank < count.
inline Cut cut_at_rank(const float* numbers, std::size_t count, std::size_t rank, NumberRange extent, float* low,
                       float* high) {
  constexpr std::size_t kFew = 256;  // 64 and 128 take up to a tenth longer, 512 as long
  std::size_t below = 0;
  while (count > kFew) {
    const float pivot = pivot_near(numbers, count, rank, extent);
    const auto is_less = [&](const auto& x) { return x < FloatLanes(pivot); };
    const auto is_no_more = [&](const auto& x) { return x <= FloatLanes(pivot); };
    std::size_t lows = partition_numbers(numbers, count, is_less, low, high);
    if (lows == 0) {  // none is less than the pivot, and all are in `high`
      numbers = high;
      lows = partition_numbers(numbers, count, is_no_more, low, high);
      if (rank < lows) return {pivot, below};
    }
    const bool is_low = rank < lows;
    numbers = is_low ? low : high;
    count = is_low ? lows : count - lows;
    (is_low ? extent.high : extent.low) = pivot;
    rank -= is_low ? 0 : lows;
    below += is_low ? 0 : lows;
  }
  const Cut cut = cut_few(numbers, count, rank, extent);
  return {cut.at, below + cut.below};
}

}  // namespace tamis::TAMIS_ISA
