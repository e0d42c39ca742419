// The vertices of several pairs at once, one pair a lane.
#pragma once
#include <array>

#include "numbers/lanes.hpp"
#include "numbers/vec.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "search/kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

/// The three coordinates of a vertex at t=0 or t=1.
inline const double* position(const PackedVertex* vertices, std::int32_t vertex, bool at_end) {
  return vertices[vertex].at + (at_end ? 4 : 0);
}
inline const double* position(const StepRows& vertices, std::int32_t vertex, bool at_end) {
  return at_end ? vertices.end + vertex * vertices.end_stride : vertices.start + vertex * vertices.start_stride;
}

#if XSIMD_WITH_AVX
/// Three coordinates and any fourth number; of a StepRows no more than the three are read.
inline __m256d load_position(const PackedVertex* vertices, std::int32_t vertex, bool at_end) {
  return _mm256_load_pd(position(vertices, vertex, at_end));
}
inline __m256d load_position(const StepRows& vertices, std::int32_t vertex, bool at_end) {
#if XSIMD_WITH_AVX512F
  return _mm256_maskz_loadu_pd(7, position(vertices, vertex, at_end));
#else
  return _mm256_maskload_pd(position(vertices, vertex, at_end), _mm256_setr_epi64x(-1, -1, -1, 0));
#endif
}
#endif

/// One vertex of as many pairs as there are lanes, at t=0 or t=1: rows, transposed.
template <class Vertices>
inline Vec3<DoubleLanes> load_vertices_at(Vertices vertices, bool at_end, const std::int32_t* index) {
#if XSIMD_WITH_AVX
  const auto row = [&](int i) { return load_position(vertices, index[i], at_end); };
#if XSIMD_WITH_AVX512F
  const auto rows = [&](int low, int high) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(row(low)), row(high), 1);
  };
  const __m512d r0 = rows(0, 2), r1 = rows(1, 3), r2 = rows(4, 6), r3 = rows(5, 7);
  const __m512d xz0 = _mm512_unpacklo_pd(r0, r1), xz1 = _mm512_unpacklo_pd(r2, r3);
  const __m512d y0 = _mm512_unpackhi_pd(r0, r1), y1 = _mm512_unpackhi_pd(r2, r3);
  return {_mm512_shuffle_f64x2(xz0, xz1, 0x88), _mm512_shuffle_f64x2(y0, y1, 0x88),
          _mm512_shuffle_f64x2(xz0, xz1, 0xdd)};
#else
  const __m256d r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
  const __m256d xz0 = _mm256_unpacklo_pd(r0, r1), xz1 = _mm256_unpacklo_pd(r2, r3);
  const __m256d y0 = _mm256_unpackhi_pd(r0, r1), y1 = _mm256_unpackhi_pd(r2, r3);
  return {_mm256_permute2f128_pd(xz0, xz1, 0x20), _mm256_permute2f128_pd(y0, y1, 0x20),
          _mm256_permute2f128_pd(xz0, xz1, 0x31)};
#endif
#else
  const double *row0 = position(vertices, index[0], at_end), *row1 = position(vertices, index[1], at_end);
  const DoubleLanes xy0 = DoubleLanes::load_unaligned(row0), xy1 = DoubleLanes::load_unaligned(row1);
  return {xsimd::zip_lo(xy0, xy1), xsimd::zip_hi(xy0, xy1), DoubleLanes{row0[2], row1[2]}};
#endif
}

/// The vertices of pairs, [place in the pair].
template <PairKind kind>
using VertexLanes = std::array<Vec3<DoubleLanes>, vertex_count(kind)>;

template <PairKind kind, class Vertices>
inline VertexLanes<kind> load_vertices_at(Vertices vertices, bool at_end, const PairBuffer& pairs, int first) {
  VertexLanes<kind> result;
  for (std::size_t corner = 0; corner < result.size(); ++corner)
    result[corner] = load_vertices_at(vertices, at_end, pairs.corner[corner] + first);
  return result;
}

template <std::size_t count>
inline Vec3<DoubleLanes> difference(const std::array<Vec3<DoubleLanes>, count>& at, VertexDifference v) {
  return at[v.to] - at[v.from];
}

/// Bits of the lanes that hold a pair, of `lanes` lanes from `first` on.
inline unsigned lanes_in_use(const PairBuffer& pairs, int first, int lanes = kDoubleLanes) {
  return first_lanes(pairs.count - first, lanes);
}

}  // namespace tamis::TAMIS_ISA
