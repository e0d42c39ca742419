// A pair on a piece of its path: the motion of its chords, and the certificates for the curves. With x(t) = chord(t) +
// s(t) and |s(t)| <= deviation, moving both ends of the chord by the same s(t) gives x(t). So Bernstein coefficients
// computed from ends that are widened by the deviation hold for the curve. The filters for straight motion run on
// intervals (docs/numerics/curves.md, "Curved motion").
#pragma once
#include <cmath>

#include "curves/motions/fine_point.hpp"
#include "curves/paths/path_reader.hpp"
#include "pair/distance/closest.hpp"
#include "pair/filters/dnf.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {

template <PairKind kind, class T>
class Chords {
 public:
  using I = BasicInterval<T>;
  using Deviations = std::array<double, 4>;

  Chords(const Moment<T>& from, const Moment<T>& to, const Deviations& deviations,
         const StraightDirections& directions = kNoDirections)
      : from_(from), to_(to), deviations_(deviations), directions_(directions) {}

  /// The vectors of the pair at both ends, widened by the deviations.
  PairMotion<I> motion() const { return motion(deviations_); }
  /// The same vectors without the deviations. They enclose the pair at both ends, but not between.
  PairMotion<I> at_ends() const { return motion(Deviations{}); }

  /// True if the pair is proven farther apart than the separation. Tries an axis that turns linearly from the gap of
  /// the closest points at one end to the gap at the other end. Then tries a direction along which a vertex does not
  /// deviate.
  bool axis_proves_free(const PairMotion<I>& ends, double separation = 0) const {
    const Vec3<I> n0 = gap(ends.e.at0, ends.f.at0, ends.d.at0), n1 = gap(ends.e.at1, ends.f.at1, ends.d.at1);
    if (axes_prove_free(axis(n0), axis(n1), separation)) return true;
    const auto known = std::ranges::find_if(directions_, [](const auto& d) { return d.is_known(); });
    return known != directions_.end() && direction_proves_free(ends, vector(known->direction), separation);
  }

  /// Approximates the distance of the features at the start of the piece.
  double gap_at_start(const PairMotion<I>& ends) const {
    const Vec3<I> n = gap(ends.e.at0, ends.f.at0, ends.d.at0);
    return nearest_double(length_above(n).upper);
  }

 private:
  PairMotion<I> motion(const Deviations& deviations) const {
    const auto moving = [&](const VertexDifference& difference) {
      const auto [i, j] = difference;
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

  /// An axis at one end of the piece, not normalized, and a bound of |n . s| for the deviation s of each vertex.
  struct Axis {
    Vec3<I> n;
    I length;
    std::array<I, 4> deviations;
  };
  Axis axis(const Vec3<I>& n) const {
    Axis axis{n, length_above(n), {}};
    for (std::size_t i = 0; i < 4; ++i) axis.deviations[i] = axis.length * I(T(deviations_[i]));
    return axis;
  }
  /// A deviation s orthogonal to the direction d has |n . s| <= |n x d| / |d| |s|.
  Axis sharp_axis(const Vec3<I>& n) const {
    Axis sharp = axis(n);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [d, per_length] = directions_[i];
      if (!directions_[i].is_known()) continue;
      const I across = length_above(cross(n, vector(d))) * I(T(per_length));
      if (across.upper < sharp.length.upper) sharp.deviations[i] = across * I(T(deviations_[i]));
    }
    return sharp;
  }

  /// For features that lie, or nearly lie, in planes orthogonal to the direction d. Tries d itself as the axis, then
  /// the features' normals, since the planes may be tilted a little. Then tries the normals of their sides in that
  /// plane. Closest points give no axis if the gap is no larger than rounding, and a coarse one if it is little larger.
  bool direction_proves_free(const PairMotion<I>& ends, const Vec3<I>& d, double separation) const {
    const double deviation = *std::max_element(deviations_.begin(), deviations_.end());
    const double thin = separation + 8 * std::max(deviation, from_.error);
    for (const auto& [i, j] : difference_corners(kind))
      if (!(std::fabs(nearest_double(dot(d, from_.points[i] - from_.points[j]).middle())) <= thin)) return false;
    const auto prove_free = [&](const Vec3<I>& at0, const Vec3<I>& at1) {
      return axes_prove_free(sharp_axis(at0), sharp_axis(at1), separation);
    };
    const Vec3<I> towards = towards_first(d, from_);
    if (prove_free(towards, towards)) return true;
    if (!can_cross(kind)) return false;
    const auto normals_prove_free = [&](const Vec3<I>& at0, const Vec3<I>& at1) {
      return prove_free(towards_first(at0, from_), towards_first(at1, to_));
    };
    if (normals_prove_free(cross(ends.e.at0, ends.f.at0), cross(ends.e.at1, ends.f.at1))) return true;
    const auto side_proves_free = [&](const Moving<I>& side) {
      return normals_prove_free(cross(d, side.at0), cross(d, side.at1));
    };
    return side_proves_free(ends.e) || side_proves_free(ends.f) ||
           (kind == PairKind::vertex_face && side_proves_free(ends.f - ends.e));
  }

  bool axes_prove_free(const Axis& a0, const Axis& a1, double separation) const {
    const I apart = T(separation), separation0 = a0.length * apart, separation1 = a1.length * apart;
    for (const auto& [i, j] : difference_corners(kind)) {
      const auto c0 = from_.points[i] - from_.points[j], c1 = to_.points[i] - to_.points[j];
      const I least0 = separation0 + a0.deviations[i] + a0.deviations[j];
      const I least1 = separation1 + a1.deviations[i] + a1.deviations[j];
      if (!(dot(a0.n, c0) > least0 && dot(a1.n, c1) > least1 && dot(a0.n, c1) + dot(a1.n, c0) > least0 + least1))
        return false;
    }
    return true;
  }

  static Vec3<I> vector(const Vec3<double>& v) { return {I(T(v.x)), I(T(v.y)), I(T(v.z))}; }
  /// The middle of n, negated if it points away from the first feature.
  static Vec3<I> towards_first(const Vec3<I>& n, const Moment<T>& at) {
    const auto [i, j] = difference_corners(kind)[0];
    const Vec3<I> middle{I(n.x.middle()), I(n.y.middle()), I(n.z.middle())};
    return dot(middle, at.points[i] - at.points[j]).middle() < T(0) ? -middle : middle;
  }
  static Vec3<I> gap(const Vec3<I>& e, const Vec3<I>& f, const Vec3<I>& d) {
    const auto middle = [](const Vec3<I>& v) {
      return Vec3<double>{nearest_double(v.x.middle()), nearest_double(v.y.middle()), nearest_double(v.z.middle())};
    };
    const Vec3<double> gap = closest_points(kind, middle(e), middle(f), middle(d)).gap;
    return vector(gap);
  }
  static I length_above(const Vec3<I>& v) {
    const double length = std::sqrt(upper_double(dot(v, v).upper));
    return I(T(rounding::above(rounding::above(length))));
  }

  const Moment<T>& from_;
  const Moment<T>& to_;
  const Deviations& deviations_;
  const StraightDirections& directions_;
};

/// The sign of the coplanarity at one time; 0 if its interval holds zero.
template <class T>
int side_of(const Vec3<BasicInterval<T>>& e, const Vec3<BasicInterval<T>>& f, const Vec3<BasicInterval<T>>& d) {
  const BasicInterval<T> k = dot(d, cross(e, f));
  return k.lower > T(0) ? 1 : k.upper < T(0) ? -1 : 0;
}

/// True if the features cross, each strictly inside the other, whenever their four points are coplanar during the
/// motion. Proven if the side polynomials of NCF have the strict signs of the inside.
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
  else  // the sides of b0 and b1 along the first edge, of a0 and a1 along the second
    return is_negative(-m.d, m.e) && is_negative(m.d + m.f, m.e) && is_negative(-m.d, m.f) &&
           is_negative(m.d - m.e, m.f);
}

}  // namespace tamis
