// Pairs at rest, one a lane: only the vertices' positions at t=0 are read.
#pragma once
#include "kernels/load_motion.hpp"
#include "solve/rest_distance.hpp"

namespace tamis::TAMIS_ISA {

/// Differences to - from at t=0 of as many pairs as there are lanes: half a row each, turned into columns.
inline Vec3<DoubleLanes> load_start_difference(const PackedVertex* vertices, const std::int32_t* to,
                                               const std::int32_t* from) {
#if XSIMD_WITH_AVX512F
  const auto row = [&](int i) {
    return _mm256_sub_pd(_mm256_load_pd(vertices[to[i]].at), _mm256_load_pd(vertices[from[i]].at));
  };
  const auto rows = [&](int low, int high) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(row(low)), row(high), 1);
  };
  const __m512d r0 = rows(0, 2), r1 = rows(1, 3), r2 = rows(4, 6), r3 = rows(5, 7);
  const __m512d xz0 = _mm512_unpacklo_pd(r0, r1), xz1 = _mm512_unpacklo_pd(r2, r3);
  const __m512d y0 = _mm512_unpackhi_pd(r0, r1), y1 = _mm512_unpackhi_pd(r2, r3);
  return {_mm512_shuffle_f64x2(xz0, xz1, 0x88), _mm512_shuffle_f64x2(y0, y1, 0x88),
          _mm512_shuffle_f64x2(xz0, xz1, 0xdd)};
#else
  DoubleLanes columns[4];
  for (int chunk = 0; chunk < 4; chunk += kDoubleLanes) {
    DoubleLanes rows[kDoubleLanes];
    for (int i = 0; i < kDoubleLanes; ++i)
      rows[i] = DoubleLanes::load_aligned(vertices[to[i]].at + chunk) -
                DoubleLanes::load_aligned(vertices[from[i]].at + chunk);
    transpose(rows);
    for (int i = 0; i < kDoubleLanes; ++i) columns[chunk + i] = rows[i];
  }
  return {columns[0], columns[1], columns[2]};
#endif
}

inline DoubleLanes largest(const Vec3<DoubleLanes>& v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

/// Some pairs' poses, scaled by a power of two, and that power.
struct LoadedPoses {
  PairPose<DoubleLanes> pose;
  DoubleLanes scale;
};

template <PairKind kind>
inline LoadedPoses load_pose(const PackedVertex* vertices, const PairBuffer& pairs, int first,
                             const PairSeparation& separation) {
  const auto difference = [&](VertexDifference v) {
    return load_start_difference(vertices, pairs.corner[v.to] + first, pairs.corner[v.from] + first);
  };
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = difference(kVectors.e), f = difference(kVectors.f), d = difference(kVectors.d);
  const DoubleLanes size_e = largest(e), size_f = largest(f), size_d = largest(d);
  const DoubleLanes scale = scale_to_one(max(max(size_e, size_f), size_d));
  return {{scale * e, scale * f, scale * d, scale * size_e, scale * size_f, scale * size_d,
           scale * load_separation<kind>(vertices, pairs, first, separation)},
          scale};
}

}  // namespace tamis::TAMIS_ISA
