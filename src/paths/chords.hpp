// A pair on a piece of its path, as the motion of its chords, and what certificates say of it. With x(t) = chord(t) +
// s(t) and |s(t)| <= deviation, both ends of the chord moved by the same s(t) give x(t): so a Bernstein coefficient
// computed from ends that are enclosed within the deviation holds for the curve, and the filters for straight motion
// run on intervals (docs/numerics.md, "Curved motion").
#pragma once
#include <cmath>
#include <utility>

#include "distance/closest.hpp"
#include "filters/dnf.hpp"
#include "filters/ncf.hpp"
#include "motion/pair_kinds.hpp"
#include "paths/fine_point.hpp"
#include "paths/path_reader.hpp"

namespace tamis {

/// The corners of the features' difference, each the difference of two vertices: first minus second.
template <PairKind kind>
inline constexpr auto kDifferences = [] {
  using P = std::pair<std::size_t, std::size_t>;
  if constexpr (kind == PairKind::vertex_face)
    return std::array{P{0, 1}, P{0, 2}, P{0, 3}};
  else if constexpr (kind == PairKind::edge_edge)
    return std::array{P{2, 0}, P{2, 1}, P{3, 0}, P{3, 1}};
  else if constexpr (kind == PairKind::vertex_edge)
    return std::array{P{0, 1}, P{0, 2}};
  else
    return std::array{P{0, 1}};
}();

template <PairKind kind, class T>
class Chords {
 public:
  using I = BasicInterval<T>;
  using Deviations = std::array<double, 4>;

  Chords(const Moment<T>& from, const Moment<T>& to, const Deviations& deviations)
      : from_(from), to_(to), deviations_(deviations) {}

  /// The vectors of the pair at both ends, widened by the deviations.
  PairMotion<I> motion() const { return motion(deviations_); }
  /// The same without the deviations: true at the ends only.
  PairMotion<I> at_ends() const { return motion(Deviations{}); }

  /// An axis that turns linearly from the gap of the closest points at one end to that at the other.
  bool axis_proves_free(const PairMotion<I>& ends) const {
    const auto n0 = gap(ends.e.at0, ends.f.at0, ends.d.at0), n1 = gap(ends.e.at1, ends.f.at1, ends.d.at1);
    const I length0 = length_above(n0), length1 = length_above(n1);
    for (const auto& [i, j] : kDifferences<kind>) {
      const auto c0 = from_.points[i] - from_.points[j], c1 = to_.points[i] - to_.points[j];
      const I deviation = I(T(deviations_[i])) + I(T(deviations_[j]));
      const bool apart = dot(n0, c0) > length0 * deviation && dot(n1, c1) > length1 * deviation &&
                         dot(n0, c1) + dot(n1, c0) > (length0 + length1) * deviation;
      if (!apart) return false;
    }
    return true;
  }

 private:
  PairMotion<I> motion(const Deviations& deviations) const {
    const auto moving = [&](const VertexDifference& difference) {
      const auto i = static_cast<std::size_t>(difference.to), j = static_cast<std::size_t>(difference.from);
      const T deviation = (I(T(deviations[i])) + I(T(deviations[j]))).upper;
      const I wide(-deviation, deviation);
      const auto widened = [&](const Vec3<I>& v) { return Vec3<I>{v.x + wide, v.y + wide, v.z + wide}; };
      return Moving<I>{widened(from_.points[i] - from_.points[j]), widened(to_.points[i] - to_.points[j])};
    };
    constexpr SpanningVectors vectors = spanning_vectors(kind);
    const I rounding_is_enclosed(T(0));
    return {moving(vectors.e),    moving(vectors.f),    moving(vectors.d),   rounding_is_enclosed,
            rounding_is_enclosed, rounding_is_enclosed, rounding_is_enclosed};
  }

  static Vec3<I> gap(const Vec3<I>& e, const Vec3<I>& f, const Vec3<I>& d) {
    const auto middle = [](const Vec3<I>& v) {
      return Vec3<double>{nearest_double(v.x.middle()), nearest_double(v.y.middle()), nearest_double(v.z.middle())};
    };
    const Vec3<double> gap = closest_points(kind, middle(e), middle(f), middle(d)).gap;
    return {I(T(gap.x)), I(T(gap.y)), I(T(gap.z))};
  }
  static I length_above(const Vec3<I>& v) {
    const double length = std::sqrt(upper_double(dot(v, v).upper));
    return I(T(rounding::above(rounding::above(length))));
  }

  const Moment<T>& from_;
  const Moment<T>& to_;
  const Deviations& deviations_;
};

/// At every time of the motion at which the four points are coplanar the features cross, each strictly inside the
/// other: the side polynomials of NCF have the strict signs of the inside.
template <PairKind kind, class T>
bool stays_inside(const PairMotion<T>& m) {
  const auto n = normal_polynomial(m.e, m.f);
  const auto is_negative = [&](const Moving<T>& x, const Moving<T>& w) {
    return side::all_negative(side_polynomial(x, edge_plane_polynomial(w, n)), side::bounds(m, m.size_d, m.size_e));
  };
  if constexpr (!can_cross(kind))
    return false;
  else if constexpr (kind == PairKind::vertex_face)
    return is_negative(m.d, m.e) && is_negative(m.d, -m.f) && is_negative(m.d - m.e, m.f - m.e);
  else  // b0 and b1 beside the first edge, a0 and a1 beside the second
    return is_negative(-m.d, m.e) && is_negative(m.d + m.f, m.e) && is_negative(-m.d, m.f) &&
           is_negative(m.d - m.e, m.f);
}

}  // namespace tamis
