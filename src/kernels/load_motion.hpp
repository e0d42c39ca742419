// The motions of several pairs at once, one a lane.
#pragma once
#include <array>

#include "kernels/kernels.hpp"
#include "motion/pair_kinds.hpp"
#include "motion/pair_motion.hpp"
#include "numerics/lanes.hpp"

namespace tamis::TAMIS_ISA {

/// How a pair's first vertex moves: in the step, as all vertices do, or along an edge while the others rest at t=0
/// (PairBuffer).
enum class Course { step, along_edge };

/// Three numbers of a vertex: where it is at t=0 or t=1.
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
  const auto column = [&](int k) {
    const double lanes[kDoubleLanes] = {row0[k], row1[k]};
    return DoubleLanes::load_unaligned(lanes);
  };
  return {column(0), column(1), column(2)};
#endif
}

/// Vertices of pairs, [place in the pair].
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

/// As scale_to_one in motion/make_motion.cpp: 2^(-1-exponent), kept in the normal range.
inline DoubleLanes scale_to_one(const DoubleLanes& size) {
  using Int64Lanes = xsimd::batch<std::int64_t, Arch>;
  const Int64Lanes biased = xsimd::bitwise_cast<Int64Lanes>(size) >> 52;
  const Int64Lanes exponent = min(max(Int64Lanes(2045) - biased, Int64Lanes(1)), Int64Lanes(2023));
  return xsimd::bitwise_cast<DoubleLanes>(exponent << 52);
}

inline Moving<DoubleLanes> scaled(const DoubleLanes& s, const Moving<DoubleLanes>& v) { return {s * v.at0, s * v.at1}; }

/// In the unit of the vertices; the same sum as Separations::between.
template <PairKind kind>
inline DoubleLanes load_separation(const PackedVertex* vertices, const PairBuffer& pairs, int first,
                                   const PairSeparation& separation) {
  const DoubleLanes fixed(separation.fixed);
  if (!separation.has_radii) return fixed;
  double radii[2][kDoubleLanes] = {};
  for (int i = 0; i < kDoubleLanes; ++i)
    for (std::size_t corner = 0; corner < vertex_count(kind); ++corner) {
      double& radius = radii[corner < second_feature(kind) ? 0 : 1][i];
      radius = max(radius, vertices[pairs.corner[corner][first + i]].at[3]);
    }
  return DoubleLanes::load_unaligned(radii[0]) + DoubleLanes::load_unaligned(radii[1]) + fixed;
}

template <PairKind>
inline DoubleLanes load_separation(const StepRows&, const PairBuffer&, int, const PairSeparation& separation) {
  return DoubleLanes(separation.fixed);
}

/// The pairs first, first + 1, ... of the buffer; lanes past its end hold whatever the padding names. `separation` is
/// in the unit of the vertices.
template <PairKind kind, Course course = Course::step, class Vertices>
inline PairMotion<DoubleLanes> load_motion(Vertices vertices, const PairBuffer& pairs, int first,
                                           const PairSeparation& separation = {}) {
  const auto at0 = load_vertices_at<kind>(vertices, false, pairs, first);
  auto at1 = at0;
  if constexpr (course == Course::step)
    at1 = load_vertices_at<kind>(vertices, true, pairs, first);
  else
    at1[0] = load_vertices_at(vertices, false, pairs.corner[4] + first);
  const auto moving = [&](VertexDifference v) -> Moving<DoubleLanes> {
    return {difference(at0, v), difference(at1, v)};
  };
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = moving(kVectors.e), f = moving(kVectors.f), d = moving(kVectors.d);
  const DoubleLanes size_e = largest(e), size_f = largest(f), size_d = largest(d);
  const DoubleLanes scale = scale_to_one(max(max(size_e, size_f), size_d));
  return {scaled(scale, e),
          scaled(scale, f),
          scaled(scale, d),
          scale * size_e,
          scale * size_f,
          scale * size_d,
          scale * load_separation<kind>(vertices, pairs, first, separation)};
}

inline Vec3<FloatLanes> to_float(const Vec3<DoubleLanes>& low, const Vec3<DoubleLanes>& high) {
  return {to_float(low.x, high.x), to_float(low.y, high.y), to_float(low.z, high.z)};
}
inline Moving<FloatLanes> to_float(const Moving<DoubleLanes>& low, const Moving<DoubleLanes>& high) {
  return {to_float(low.at0, high.at0), to_float(low.at1, high.at1)};
}

/// Twice as many pairs, rounded to float: the rounding is within the kInput of float lanes.
template <PairKind kind>
inline PairMotion<FloatLanes> load_motion_as_float(const PackedVertex* vertices, const PairBuffer& pairs, int first,
                                                   const PairSeparation& separation) {
  static_assert(kFloatLanes == 2 * kDoubleLanes);
  const auto low = load_motion<kind>(vertices, pairs, first, separation);
  const auto high = load_motion<kind>(vertices, pairs, first + kDoubleLanes, separation);
  return {to_float(low.e, high.e),
          to_float(low.f, high.f),
          to_float(low.d, high.d),
          to_float(low.size_e, high.size_e),
          to_float(low.size_f, high.size_f),
          to_float(low.size_d, high.size_d),
          to_float(low.separation, high.separation)};
}

/// As many pairs as there are lanes of floats, from the floats that boxes are made of; what rounding the vertices to
/// these may hide is in the separation.
template <PairKind kind, Course course = Course::step>
inline PairMotion<FloatLanes> load_box_motion(const BoxVertex* vertices, const PairBuffer& pairs, int first,
                                              const BoxSeparation& separation) {
  Moving<FloatLanes> at[vertex_count(kind)];
  FloatLanes radius[vertex_count(kind)];
  for (std::size_t corner = 0; corner < vertex_count(kind); ++corner) {
    FloatLanes columns[BoxVertex::kRadius + 1];
    load_columns(&vertices->at, pairs.corner[corner] + first, columns);
    at[corner] = {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}};
    radius[corner] = columns[BoxVertex::kRadius];
  }
  if constexpr (course == Course::along_edge) {
    FloatLanes columns[BoxVertex::kRadius + 1];
    load_columns(&vertices->at, pairs.corner[4] + first, columns);
    at[0].at1 = {columns[0], columns[1], columns[2]};
  }
  const auto moving = [&](VertexDifference v) { return at[v.to] - at[v.from]; };
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = moving(kVectors.e), f = moving(kVectors.f), d = moving(kVectors.d);
  PairMotion<FloatLanes> motion{e, f, d, largest(e), largest(f), largest(d), FloatLanes(separation.fixed)};
  if (separation.has_radii) {
    FloatLanes of_feature[2] = {radius[0], radius[second_feature(kind)]};
    for (std::size_t corner = 1; corner < vertex_count(kind); ++corner) {
      FloatLanes& largest_radius = of_feature[corner < second_feature(kind) ? 0 : 1];
      largest_radius = max(largest_radius, radius[corner]);
    }
    motion.separation = motion.separation + of_feature[0] + of_feature[1];
  }
  return motion;
}

/// Bits of the first `count` of `lanes` lanes, or of all.
inline unsigned first_lanes(int count, int lanes = kDoubleLanes) { return (1u << (count < lanes ? count : lanes)) - 1; }

/// Bits of the lanes that hold a pair, of `lanes` lanes from `first` on.
inline unsigned lanes_in_use(const PairBuffer& pairs, int first, int lanes = kDoubleLanes) {
  return first_lanes(pairs.count - first, lanes);
}

}  // namespace tamis::TAMIS_ISA
