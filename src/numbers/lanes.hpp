// SIMD lanes: xsimd batches for arithmetic, and what its Debian version lacks (a mask as bits, columns of rows).
// Include only from the kernels, which are compiled once per instruction set.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "numbers/error_bounds.hpp"
#include "numbers/platform.hpp"
#include "numbers/select.hpp"

#ifndef TAMIS_ISA
#error "lanes.hpp is for the kernels only: they are compiled with TAMIS_ISA set to the name of their instruction set"
#endif

namespace tamis::TAMIS_ISA {

#if XSIMD_WITH_WASM && XSIMD_WITH_SSE2
// WebAssembly's own minimum of a NaN and a number is another than x86's, which the clips in time need. -msse2 asks
// emscripten for x86's (cmake/wasm.cmake).
using Arch = xsimd::sse2;
#elif XSIMD_WITH_WASM
#error "the kernels are compiled for WebAssembly without -msse2, and would miss contacts: add it"
#else
using Arch = xsimd::default_arch;
#endif
using DoubleLanes = xsimd::batch<double, Arch>;
using FloatLanes = xsimd::batch<float, Arch>;
using IntLanes = xsimd::batch<std::int32_t, Arch>;
inline constexpr int kDoubleLanes = static_cast<int>(DoubleLanes::size);
inline constexpr int kFloatLanes = static_cast<int>(FloatLanes::size);

/// The same bits as lanes of `To`. From version 11 on xsimd::bitwise_cast takes the type of a lane. Before version 11
/// it takes the type of the batch.
template <class To, class From>
inline xsimd::batch<To, Arch> same_bits(const xsimd::batch<From, Arch>& lanes) {
  if constexpr (std::is_same_v<To, From>)
    return lanes;
  else
#if XSIMD_VERSION_MAJOR < 11
    return xsimd::bitwise_cast<xsimd::batch<To, Arch>>(lanes);
#else
    return xsimd::bitwise_cast<To>(lanes);
#endif
}

#if XSIMD_WITH_AVX && !XSIMD_WITH_AVX512F
inline int signs_of(const DoubleLanes& lanes) { return _mm256_movemask_pd(lanes); }
inline int signs_of(const FloatLanes& lanes) { return _mm256_movemask_ps(lanes); }
#elif XSIMD_WITH_SSE2 && !XSIMD_WITH_AVX
inline int signs_of(const DoubleLanes& lanes) { return _mm_movemask_pd(lanes); }
inline int signs_of(const FloatLanes& lanes) { return _mm_movemask_ps(lanes); }
#endif

/// One bit a lane, lane 0 lowest.
template <class T>
inline unsigned bits(const xsimd::batch_bool<T, Arch>& mask) {
#if XSIMD_WITH_AVX512F
  return static_cast<unsigned>(mask.data);
#elif XSIMD_WITH_SSE2
  const xsimd::batch<T, Arch> lanes(mask.data);
  if constexpr (sizeof(T) == 8)
    return static_cast<unsigned>(signs_of(same_bits<double>(lanes)));
  else
    return static_cast<unsigned>(signs_of(same_bits<float>(lanes)));
#else
  static constexpr std::uint32_t kFours[4] = {1, 2, 4, 8};
  static constexpr std::uint64_t kTwos[2] = {1, 2};
  if constexpr (sizeof(T) == 8)
    return static_cast<unsigned>(vaddvq_u64(vandq_u64(mask.data, vld1q_u64(kTwos))));
  else
    return vaddvq_u32(vandq_u32(mask.data, vld1q_u32(kFours)));
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
#elif XSIMD_WITH_SSE2
  return _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high));
#else
  return vcvt_high_f32_f64(vcvt_f32_f64(low), high);
#endif
}

/// The least of all lanes.
inline float least(const FloatLanes& lanes) {
#if XSIMD_WITH_NEON64
  return vminvq_f32(lanes);
#else
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
#endif
}

inline float greatest(const FloatLanes& lanes) { return -least(-lanes); }

/// Interleaves the lower, and the higher, two lanes of each four: a0 b0 a1 b1, and a2 b2 a3 b3.
inline FloatLanes zip_low(const FloatLanes& a, const FloatLanes& b) {
#if XSIMD_WITH_AVX512F
  return _mm512_unpacklo_ps(a, b);
#elif XSIMD_WITH_AVX
  return _mm256_unpacklo_ps(a, b);
#else
  return xsimd::zip_lo(a, b);
#endif
}
inline FloatLanes zip_high(const FloatLanes& a, const FloatLanes& b) {
#if XSIMD_WITH_AVX512F
  return _mm512_unpackhi_ps(a, b);
#elif XSIMD_WITH_AVX
  return _mm256_unpackhi_ps(a, b);
#else
  return xsimd::zip_hi(a, b);
#endif
}

/// As many fours as there are in a batch, the first in the lower lanes. `four(i)`: where the i-th begins.
template <class F>
inline FloatLanes load_fours(const F& four) {
#if XSIMD_WITH_AVX512F
  const __m512 first = _mm512_castps128_ps512(_mm_loadu_ps(four(0)));
  const __m512 two = _mm512_insertf32x4(first, _mm_loadu_ps(four(1)), 1);
  return _mm512_insertf32x4(_mm512_insertf32x4(two, _mm_loadu_ps(four(2)), 2), _mm_loadu_ps(four(3)), 3);
#elif XSIMD_WITH_AVX
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(four(0))), _mm_loadu_ps(four(1)), 1);
#else
  return FloatLanes::load_unaligned(four(0));
#endif
}

/// Loads the first seven columns of rows of eight floats: lane i gets row `index[i]` of `rows`.
inline void load_columns(const float (*rows)[8], const std::int32_t* index, FloatLanes (&columns)[7]) {
  for (int half = 0; half < 2; ++half) {
    // Each four lanes of four registers are a square of four rows by four columns, which two zips transpose.
    const auto row = [&](int i) { return load_fours([&](int q) { return rows[index[4 * q + i]] + 4 * half; }); };
    const FloatLanes r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const FloatLanes a = zip_low(r0, r2), b = zip_low(r1, r3), c = zip_high(r0, r2), d = zip_high(r1, r3);
    columns[4 * half] = zip_low(a, b);
    columns[4 * half + 1] = zip_high(a, b);
    columns[4 * half + 2] = zip_low(c, d);
    if (half == 0) columns[3] = zip_high(c, d);
  }
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
