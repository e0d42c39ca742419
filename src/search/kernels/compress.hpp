// Stream compaction: writes the lanes that a mask names to consecutive places, and pairs with their times.
#pragma once
#include <array>
#include <cstdint>

#include "numbers/lanes.hpp"
#include "pair/motion/time_clip.hpp"
#include "search/kernels/kernels.hpp"
#include "search/kernels/sixteen_lanes.hpp"

namespace tamis::TAMIS_ISA {

#if XSIMD_WITH_AVX2 && !XSIMD_WITH_AVX512F
/// [mask]: the positions of its bits, lowest first, one a byte.
inline constexpr auto kBitPositions = [] {
  std::array<std::uint64_t, 256> table{};
  for (unsigned mask = 0; mask < 256; ++mask)
    for (unsigned bit = 0, count = 0; bit < 8; ++bit)
      if (mask >> bit & 1) table[mask] |= std::uint64_t{bit} << (8 * count++);
  return table;
}();
#elif XSIMD_WITH_NEON64 || XSIMD_WITH_WASM
/// [mask]: the bytes of the lanes of its bits, lowest first. Behind them 255, which stands for zero.
inline constexpr auto kBytesOfLanes = [] {
  std::array<std::array<std::uint8_t, 16>, 16> table{};
  for (auto& order : table) order.fill(255);
  for (unsigned mask = 0; mask < 16; ++mask)
    for (unsigned lane = 0, count = 0; lane < 4; ++lane)
      if (mask >> lane & 1)
        for (unsigned byte = 0; byte < 4; ++byte) table[mask][count++] = static_cast<std::uint8_t>(4 * lane + byte);
  return table;
}();
#endif

/// Writes the lanes of `mask` to consecutive places from `to` on. A whole batch may be written: after them comes some
/// lane of the batch, or zero.
template <class T>
inline void store_compressed(unsigned mask, const xsimd::batch<T, Arch>& lanes, T* to) {
  static_assert(sizeof(T) == 4);
#if XSIMD_WITH_AVX512F
  const __m512i raw = same_bits<std::int32_t>(lanes);
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), raw));
#elif XSIMD_WITH_AVX2
  const __m256i raw = same_bits<std::int32_t>(lanes);
  const __m256i order = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&kBitPositions[mask])));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(raw, order));
#elif XSIMD_WITH_NEON64
  const uint8x16_t raw = vreinterpretq_u8_s32(same_bits<std::int32_t>(lanes));
  vst1q_s32(reinterpret_cast<std::int32_t*>(to),
            vreinterpretq_s32_u8(vqtbl1q_u8(raw, vld1q_u8(kBytesOfLanes[mask].data()))));
#elif XSIMD_WITH_WASM
  const v128_t raw = same_bits<std::int32_t>(lanes);
  wasm_v128_store(to, wasm_i8x16_swizzle(raw, wasm_v128_load(kBytesOfLanes[mask].data())));
#else
  alignas(64) T all[IntLanes::size];
  lanes.store_aligned(all);
  for (unsigned i = 0; i < IntLanes::size; ++i) {
    *to = all[i];
    to += mask >> i & 1;
  }
#endif
}

/// Appends `first` + i to the list for each bit i of `mask`, of sixteen.
inline void append_bits(unsigned mask, int first, std::int32_t* list, int& count) {
  for_sixteen_lanes([&](int lane) {
    const unsigned some = mask >> lane & ((1u << kFloatLanes) - 1);
    store_compressed(some, counting_from(first + lane), list + count);
    count += count_bits(some);
  });
}

/// The times when pairs may touch. `Lanes`: of floats or of doubles.
template <class Lanes>
inline TimeInterval<Lanes> load_time(const PairBuffer& pairs, int first) {
  return {Lanes::load_unaligned(pairs.t_in + first), Lanes::load_unaligned(pairs.t_out + first)};
}

/// Copies the corners of pair `from` of `in` to pair `to` of `out`.
template <int corners = 4>
inline void copy_corners(const PairBuffer& in, int from, PairBuffer& out, int to) {
  for (int c = 0; c < corners; ++c) out.corner[c][to] = in.corner[c][from];
}

/// Appends pair `from` of `in`, with its times, to `out`.
inline void copy_pair(const PairBuffer& in, int from, PairBuffer& out) {
  copy_corners<5>(in, from, out, out.count);
  out.t_in[out.count] = in.t_in[from];
  out.t_out[out.count] = in.t_out[from];
  ++out.count;
}

/// Copies the corners of those pairs from `first` on that `mask` names to place `to` and on. `out` may be `in`, if only
/// pairs that have been read are overwritten.
template <int corners = 4>
inline void store_corners(unsigned mask, const PairBuffer& in, int first, PairBuffer& out, int to) {
  for (int c = 0; c < corners; ++c)
    store_compressed(mask, IntLanes::load_unaligned(in.corner[c] + first), out.corner[c] + to);
}

/// Copies these pairs with the given times. Returns their number.
template <int corners = 4>
inline int store_pairs(unsigned mask, const PairBuffer& in, int first, const TimeInterval<FloatLanes>& time,
                       PairBuffer& out, int to) {
  store_corners<corners>(mask, in, first, out, to);
  store_compressed(mask, time.t_in, out.t_in + to);
  store_compressed(mask, time.t_out, out.t_out + to);
  return count_bits(mask);
}

}  // namespace tamis::TAMIS_ISA
