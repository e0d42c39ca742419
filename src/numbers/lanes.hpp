// SIMD lanes: xsimd batches for arithmetic, and what its Debian version lacks (a mask as bits, columns of rows).
// Include only from the kernels, which are compiled once per instruction set.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <xsimd/xsimd.hpp>

#include "numbers/error_bounds.hpp"
#include "numbers/platform.hpp"
#include "numbers/select.hpp"

#ifndef TAMIS_ISA
#error "lanes.hpp is for the kernels only: they are compiled with TAMIS_ISA set to the name of their instruction set"
#endif

namespace tamis::TAMIS_ISA {

using Arch = xsimd::default_arch;
using DoubleLanes = xsimd::batch<double, Arch>;
using FloatLanes = xsimd::batch<float, Arch>;
using IntLanes = xsimd::batch<std::int32_t, Arch>;
inline constexpr int kDoubleLanes = static_cast<int>(DoubleLanes::size);
inline constexpr int kFloatLanes = static_cast<int>(FloatLanes::size);

/// The same bits as lanes of `To`. From version 11 on xsimd::bitwise_cast takes the type of a lane. Before version 11
/// it takes the type of the batch.
template <class To, class From>
inline xsimd::batch<To, Arch> same_bits(const xsimd::batch<From, Arch>& lanes) {
#if XSIMD_VERSION_MAJOR < 11
  return xsimd::bitwise_cast<xsimd::batch<To, Arch>>(lanes);
#else
  return xsimd::bitwise_cast<To>(lanes);
#endif
}

/// One bit a lane, lane 0 lowest.
template <class T>
inline unsigned bits(const xsimd::batch_bool<T, Arch>& mask) {
#if XSIMD_WITH_AVX512F
  return static_cast<unsigned>(mask.data);
#elif XSIMD_WITH_AVX
  if constexpr (sizeof(T) == 8)
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd((__m256i)mask.data)));
  else
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps((__m256i)mask.data)));
#elif XSIMD_WITH_SSE2
  if constexpr (sizeof(T) == 8)
    return static_cast<unsigned>(_mm_movemask_pd(_mm_castsi128_pd((__m128i)mask.data)));
  else
    return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps((__m128i)mask.data)));
#else
  bool flags[xsimd::batch_bool<T, Arch>::size];
  mask.store_unaligned(flags);
  unsigned result = 0;
  for (unsigned i = 0; i < xsimd::batch_bool<T, Arch>::size; ++i) result |= unsigned(flags[i]) << i;
  return result;
#endif
}

/// Bits of the first `count` of `lanes` lanes, or of all if there are fewer.
inline unsigned first_lanes(int count, int lanes = kDoubleLanes) { return (1u << (count < lanes ? count : lanes)) - 1; }

/// The number of bits that are set. REQUIRES (not checked: lanes): no bit beyond the lanes of floats.
inline int count_bits(unsigned mask) {
  if constexpr (kFloatLanes == 4)  // the baseline has no instruction for it
    return static_cast<int>(0x4332322132212110u >> (4 * mask) & 15);
  return std::popcount(mask);
}

/// first, first + 1, ...
inline IntLanes counting_from(int first) {
  alignas(64) static constexpr std::int32_t kCount[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  return IntLanes(first) + IntLanes::load_aligned(kCount);
}

/// Two batches of doubles rounded to one of floats, `low` in the lower lanes.
inline FloatLanes to_float(const DoubleLanes& low, const DoubleLanes& high) {
#if XSIMD_WITH_AVX512F
  return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(low)), _mm512_cvtpd_ps(high), 1);
#elif XSIMD_WITH_AVX
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(low)), _mm256_cvtpd_ps(high), 1);
#else
  double wide[kFloatLanes];
  float narrow[kFloatLanes];
  low.store_unaligned(wide);
  high.store_unaligned(wide + kDoubleLanes);
  for (int i = 0; i < kFloatLanes; ++i) narrow[i] = static_cast<float>(wide[i]);
  return FloatLanes::load_unaligned(narrow);
#endif
}

/// The least of all lanes.
inline float least(const FloatLanes& lanes) {
  FloatLanes fours = lanes;  // in the first lane of each four: the least of the four
#if XSIMD_WITH_AVX512F
  fours = min(fours, FloatLanes(_mm512_permute_ps(fours, 0xb1)));
  fours = min(fours, FloatLanes(_mm512_permute_ps(fours, 0x4e)));
#elif XSIMD_WITH_AVX
  fours = min(fours, FloatLanes(_mm256_permute_ps(fours, 0xb1)));
  fours = min(fours, FloatLanes(_mm256_permute_ps(fours, 0x4e)));
#endif
  alignas(64) float all[FloatLanes::size];
  fours.store_aligned(all);
  constexpr std::size_t kStride = FloatLanes::size > 4 ? 4 : 1;
  float result = all[0];
  for (std::size_t i = kStride; i < FloatLanes::size; i += kStride) result = all[i] < result ? all[i] : result;
  return result;
}

inline float greatest(const FloatLanes& lanes) { return -least(-lanes); }

/// Loads the first seven columns of rows of eight floats: lane i gets row `index[i]` of `rows`.
inline void load_columns(const float (*rows)[8], const std::int32_t* index, FloatLanes (&columns)[7]) {
#if XSIMD_WITH_SSE2
  constexpr int kQuarters = static_cast<int>(FloatLanes::size) / 4;
#if XSIMD_WITH_AVX512F
  using Raw = __m512;
  const auto low = [](Raw a, Raw b) { return _mm512_unpacklo_ps(a, b); };
  const auto high = [](Raw a, Raw b) { return _mm512_unpackhi_ps(a, b); };
  const auto low_pairs = [](Raw a, Raw b) { return _mm512_shuffle_ps(a, b, 0x44); };
  const auto high_pairs = [](Raw a, Raw b) { return _mm512_shuffle_ps(a, b, 0xee); };
  const auto join = [](const __m128(&q)[kQuarters]) {
    const Raw two = _mm512_insertf32x4(_mm512_castps128_ps512(q[0]), q[1], 1);
    return _mm512_insertf32x4(_mm512_insertf32x4(two, q[2], 2), q[3], 3);
  };
#elif XSIMD_WITH_AVX
  using Raw = __m256;
  const auto low = [](Raw a, Raw b) { return _mm256_unpacklo_ps(a, b); };
  const auto high = [](Raw a, Raw b) { return _mm256_unpackhi_ps(a, b); };
  const auto low_pairs = [](Raw a, Raw b) { return _mm256_shuffle_ps(a, b, 0x44); };
  const auto high_pairs = [](Raw a, Raw b) { return _mm256_shuffle_ps(a, b, 0xee); };
  const auto join = [](const __m128(&q)[kQuarters]) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(q[0]), q[1], 1);
  };
#else
  using Raw = __m128;
  const auto low = [](Raw a, Raw b) { return _mm_unpacklo_ps(a, b); };
  const auto high = [](Raw a, Raw b) { return _mm_unpackhi_ps(a, b); };
  const auto low_pairs = [](Raw a, Raw b) { return _mm_shuffle_ps(a, b, 0x44); };
  const auto high_pairs = [](Raw a, Raw b) { return _mm_shuffle_ps(a, b, 0xee); };
  const auto join = [](const __m128(&q)[kQuarters]) { return q[0]; };
#endif
  // Quarter q of four registers is a square of four rows by four columns, transposed in place.
  for (std::size_t half = 0; half < 2; ++half) {
    Raw r[4];
    for (int i = 0; i < 4; ++i) {
      __m128 quarters[kQuarters];
      for (int q = 0; q < kQuarters; ++q) quarters[q] = _mm_loadu_ps(rows[index[4 * q + i]] + 4 * half);
      r[i] = join(quarters);
    }
    const Raw a = low(r[0], r[1]), b = low(r[2], r[3]);
    const Raw c = high(r[0], r[1]), d = high(r[2], r[3]);
    columns[4 * half] = low_pairs(a, b);
    columns[4 * half + 1] = high_pairs(a, b);
    columns[4 * half + 2] = low_pairs(c, d);
    if (half == 0) columns[3] = high_pairs(c, d);
  }
#else
  for (int column = 0; column < 7; ++column) {
    float lanes[FloatLanes::size];
    for (std::size_t i = 0; i < FloatLanes::size; ++i) lanes[i] = rows[index[i]][column];
    columns[column] = FloatLanes::load_unaligned(lanes);
  }
#endif
}

}  // namespace tamis::TAMIS_ISA

namespace tamis {

#if XSIMD_WITH_SSE2
/// x86's minimum and maximum are the second operand where the first is NaN.
template <class Number>
struct Masked<xsimd::batch<Number, TAMIS_ISA::Arch>> {
  using Lanes = xsimd::batch<Number, TAMIS_ISA::Arch>;
  using Mask = xsimd::batch_bool<Number, TAMIS_ISA::Arch>;
  static constexpr bool kIsMaskWide = sizeof(Mask) == sizeof(Lanes);

  static Lanes zero_unless(const Mask& mask, const Lanes& a) {
    if constexpr (kIsMaskWide)
      return Lanes(mask.data) & a;
    else
      return select(mask, a, Lanes(0));
  }
  static Lanes nan_where(const Mask& mask, const Lanes& a) {
    if constexpr (kIsMaskWide)
      return Lanes(mask.data) | a;
    else
      return select(mask, Lanes(std::numeric_limits<Number>::quiet_NaN()), a);
  }
  static Lanes min_number(const Lanes& a, const Lanes& b) { return min(a, b); }
  static Lanes max_number(const Lanes& a, const Lanes& b) { return max(a, b); }
};
#endif

/// A ratio without a division, which would cost as much as twenty other operations. The bits of b give a guess at 1/b,
/// within 5.1%. A step of Newton squares its error. Measured over all mantissas: 2.56e-3 (numbers/lanes_test). REQUIRES
/// (not checked: lanes): |b| in [2^-100, 2^100].
template <>
struct Ratio<TAMIS_ISA::FloatLanes> {
  using Lanes = TAMIS_ISA::FloatLanes;
  static constexpr double kError = 0x1.6p-9;
  static Lanes of(const Lanes& a, const Lanes& b) {
    const auto guess = TAMIS_ISA::IntLanes(0x7ef311c3) - TAMIS_ISA::same_bits<std::int32_t>(b);
    const Lanes y = TAMIS_ISA::same_bits<float>(guess);
    return a * (y * (Lanes(2.0f) - b * y));
  }
};

namespace error_bounds {
template <>
inline constexpr double unit_roundoff<TAMIS_ISA::DoubleLanes> = 0x1p-53;
template <>
inline constexpr double unit_roundoff<TAMIS_ISA::FloatLanes> = 0x1p-24;
template <>
inline constexpr double underflow<TAMIS_ISA::FloatLanes> = 0x1p-100;
}  // namespace error_bounds

}  // namespace tamis
