// The motions of several pairs at once, one a lane.
#pragma once
#include "numbers/lanes.hpp"
#include "pair/motion/pair_motion.hpp"
#include "search/kernels/load_vertices.hpp"

namespace tamis::TAMIS_ISA {

/// How a pair's first vertex moves: in the step, as all vertices do, or along an edge while the others rest at t=0
/// (PairBuffer).
enum class Course { step, along_edge };

/// How many corners a pair in a buffer has.
constexpr int corners_of(Course course) { return course == Course::along_edge ? 5 : 4; }

/// scale_below_one() (numbers/scale.hpp) in lanes: 2^(-1-exponent), kept in the normal range. For 0 the two differ.
inline DoubleLanes scale_to_one(const DoubleLanes& size) {
  using Int64Lanes = xsimd::batch<std::int64_t, Arch>;
  const Int64Lanes biased = same_bits<std::int64_t>(size) >> 52;
  const Int64Lanes exponent = min(max(Int64Lanes(2045) - biased, Int64Lanes(1)), Int64Lanes(2023));
  return same_bits<double>(exponent << 52);
}

inline Moving<DoubleLanes> scaled(const DoubleLanes& s, const Moving<DoubleLanes>& v) { return {s * v.at0, s * v.at1}; }

/// The pairs' separations in the unit of the vertices: the same sum as Separations::between.
template <PairKind kind>
inline DoubleLanes load_separation(const PackedVertex* vertices, const PairBuffer& pairs, int first,
                                   const PairSeparation<double>& separation) {
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
inline DoubleLanes load_separation(const StepRows&, const PairBuffer&, int, const PairSeparation<double>& separation) {
  return DoubleLanes(separation.fixed);
}

/// The pairs first, first + 1, ... of the buffer. Lanes past its end hold whatever the padding names. `separation` is
/// in the unit of the vertices.
template <PairKind kind, Course course = Course::step, class Vertices>
inline PairMotion<DoubleLanes> load_motion(Vertices vertices, const PairBuffer& pairs, int first,
                                           const PairSeparation<double>& separation = {}) {
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

/// The sum of all components: not finite if one of them is not.
inline DoubleLanes sum(const Moving<DoubleLanes>& v) {
  return (v.at0.x + v.at0.y + v.at0.z) + (v.at1.x + v.at1.y + v.at1.z);
}

/// Bits of the lanes all of whose numbers are finite.
inline unsigned finite_lanes(const PairMotion<DoubleLanes>& m) {
  const DoubleLanes all = sum(m.e) + sum(m.f) + sum(m.d);
  return bits(all - all == DoubleLanes(0));  // NOLINT(misc-redundant-expression): NaN where all is not finite
}

inline Vec3<FloatLanes> to_float(const Vec3<DoubleLanes>& low, const Vec3<DoubleLanes>& high) {
  return {to_float(low.x, high.x), to_float(low.y, high.y), to_float(low.z, high.z)};
}
inline Moving<FloatLanes> to_float(const Moving<DoubleLanes>& low, const Moving<DoubleLanes>& high) {
  return {to_float(low.at0, high.at0), to_float(low.at1, high.at1)};
}

/// The motions of twice as many pairs, in doubles, rounded to float. The rounding is within the kInput of float lanes.
template <PairKind kind>
inline PairMotion<FloatLanes> load_motion_as_float(const MotionView& view, const PairBuffer& pairs, int first) {
  static_assert(kFloatLanes == 2 * kDoubleLanes);
  const auto low = load_motion<kind>(view.vertices, pairs, first, view.separation);
  const auto high = load_motion<kind>(view.vertices, pairs, first + kDoubleLanes, view.separation);
  return {to_float(low.e, high.e),
          to_float(low.f, high.f),
          to_float(low.d, high.d),
          to_float(low.size_e, high.size_e),
          to_float(low.size_f, high.size_f),
          to_float(low.size_d, high.size_d),
          to_float(low.separation, high.separation)};
}

/// The motions of as many pairs as there are lanes of floats, from the floats that boxes are made of. The separation
/// includes what rounding the vertices to these floats may hide.
template <PairKind kind, Course course = Course::step>
inline PairMotion<FloatLanes> load_box_motion(const MotionView& view, const PairBuffer& pairs, int first) {
  Moving<FloatLanes> at[vertex_count(kind)];
  FloatLanes radius[vertex_count(kind)];
  for (std::size_t corner = 0; corner < vertex_count(kind); ++corner) {
    FloatLanes columns[BoxVertex::kRadius + 1];
    load_columns(&view.box_vertices->at, pairs.corner[corner] + first, columns);
    at[corner] = {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}};
    radius[corner] = columns[BoxVertex::kRadius];
  }
  if constexpr (course == Course::along_edge) {
    FloatLanes columns[BoxVertex::kRadius + 1];
    load_columns(&view.box_vertices->at, pairs.corner[4] + first, columns);
    at[0].at1 = {columns[0], columns[1], columns[2]};
    radius[0] = max(radius[0], columns[BoxVertex::kRadius]);
  }
  const auto moving = [&](VertexDifference v) { return at[v.to] - at[v.from]; };
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = moving(kVectors.e), f = moving(kVectors.f), d = moving(kVectors.d);
  PairMotion<FloatLanes> motion{e, f, d, largest(e), largest(f), largest(d), FloatLanes(view.box_separation.fixed)};
  if (view.box_separation.has_radii) {
    FloatLanes of_feature[2] = {radius[0], radius[second_feature(kind)]};
    for (std::size_t corner = 1; corner < vertex_count(kind); ++corner) {
      FloatLanes& largest_radius = of_feature[corner < second_feature(kind) ? 0 : 1];
      largest_radius = max(largest_radius, radius[corner]);
    }
    motion.separation = motion.separation + of_feature[0] + of_feature[1];
  }
  return motion;
}

}  // namespace tamis::TAMIS_ISA
