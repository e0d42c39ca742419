// One crossing: where the coplanarity cubic provably passes zero exactly once during the motion, certified signs
// bracket the root, and the inside test compares the features there. This decides nearly every pair that reaches the
// solver. The rest is cut in time first (pair/narrow/decide_in_doubles.cpp). One template for double and for SIMD
// lanes. Every lane's answer depends on that lane alone.
#pragma once
#include "numbers/assert.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/motion/polynomials.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/crossing_root.hpp"
#include "pair/narrow/crossing_sides.hpp"

namespace tamis {

/// What one crossing tells of a part of the step. Times are times of the step.
template <class T>
struct Crossing {
  Mask<T> is_free;   ///< proven: no contact in that part
  Mask<T> touches;   ///< proven: contact within [lower, upper], none before in that part
  Mask<T> brackets;  ///< proven: no contact in that part but within [lower, upper]; implied by `touches`
  T lower, upper;
  T u, v;          ///< weights, see Contact; like `normal` at the root, where it touches
  Vec3<T> normal;  ///< of unit length, towards the side on which the first feature was

  static Crossing free() { return {true, false, false, T(1), T(1), T(0), T(0), {T(0), T(0), T(0)}}; }
};

namespace crossing {

/// The step's time at `s` in [0,1] of `part`, off by 3 u. A `direction` of -1 or 1 moves it that way, beyond all that
/// rounding can make here, in `s` and in a time with direction 0: 8 u.
template <class T>
inline T to_step(const TimeInterval<T>& part, const T& s, double direction) {
  const T t = (T(1) - s) * part.t_in + s * part.t_out;
  return min(max(t + T(direction * 12 * error_bounds::unit_roundoff<T>) * part.t_out, part.t_in), part.t_out);
}

/// The place in [0,1] where a cubic whose ends have one sign turns. The middle where there is no such place.
template <class T>
inline T turning_point(const std::array<T, 4>& k) {
  // K' = c0 s^2 + c1 s t + c2 t^2 with s = 1 - t; a root t/s > 0 where c0 and c2 differ in sign.
  const T c0 = k[1] - T(3) * k[0], c1 = T(2) * (k[2] - k[1]), c2 = T(3) * k[3] - k[2];
  const T root = sqrt(max(c1 * c1 - T(4) * c0 * c2, T(0)));
  const T x = (select(c2 < T(0), -root, root) - c1) / (T(2) * c2), t = x / (T(1) + x);
  return select((t > T(0x1p-10)) & (t < T(1 - 0x1p-10)), t, T(0.5));
}

}  // namespace crossing

/// One crossing in a part of a step: what signs tell before the root of `cubic` is known, then the answer at that root.
/// Keeps a reference to `step`. REQUIRES: the motion of a whole step, a part of it, and its cubic (checked: the first
/// coefficient).
template <PairKind kind, class T>
struct CrossingSearch {
  CrossingSearch(const PairMotion<T>& whole_step, const std::array<T, 4>& whole, const TimeInterval<T>& part_of_step)
      : step(whole_step), part(part_of_step), cubic(restrict_to(whole, part.t_in, part.t_out)) {
    TAMIS_ASSERT(is_whole(step) && is_part_of_step(part));
    TAMIS_ASSERT(!any(whole[0] != dot(step.d.at0, cross(step.e.at0, step.f.at0))));
    auto& k = cubic;
    unit = step.size_d * step.size_e * step.size_f;
    const T end = error_bounds::bound(error_bounds::kCoplanarityEnd, unit);
    const T middle = error_bounds::bound(error_bounds::kCoplanarityMiddle, unit);
    // A cubic that rises is negated. Then it changes its sign once, whatever the uncertain signs, unless k1 < 0 < k2.
    rises = k[0] < T(0);
    for (T& c : k) c = select(rises, -c, c);
    keeps_sign = (k[0] > end) & (k[1] > middle) & (k[2] > middle) & (k[3] > end);  // DNF
    falls_once = (k[0] > end) & (k[3] < -end) & ((k[1] > middle) | (k[2] < -middle));
    k[0] = select(falls_once, k[0], T(1));  // the others get ends that bracket, and their roots are not used
    k[3] = select(falls_once, k[3], T(-1));
  }

  Crossing<T> at_root(const T& s) const {
    const T error = error_bounds::bound(error_bounds::kCoplanarityNow, unit), fall = -crossing::slope(cubic, s);
    const T radius = T(1.5) * error / fall + T(8 * error_bounds::unit_roundoff<T>);
    const T t = crossing::to_step(part, s, 0);
    const Vec3<T> n = cross(at_time(step.e, t), at_time(step.f, t));
    // K at t, from the vectors at t. Also how far K falls, in spite of all rounding, within the radius. Where the slope
    // proves no fall, the sign of K at t itself still tells the side of t on which the root is.
    const T value = dot(at_time(step.d, t), n), turned = select(rises, -value, value);
    const T length = part.t_out - part.t_in, bend = T(error_bounds::kBend) * length * length * unit;
    const T least_fall = fall - error_bounds::bound(error_bounds::kCoplanaritySlopeNow, unit) - radius * bend;
    const T drop = radius * max(least_fall, T(0)) - error;
    const Mask<T> brackets =
        falls_once & ((radius >= s) | (turned + drop > T(0))) & ((s + radius >= T(1)) | (turned - drop < T(0)));
    const T lower = crossing::to_step(part, max(s - radius, T(0)), -1);
    const T upper = crossing::to_step(part, min(s + radius, T(1)), 1);
    const auto sides = crossing::sides<kind>(step, n, t, max(upper - t, t - lower));
    // K falls to zero if a vertex comes from n's side, and rises if the first edge does. This is because d starts from
    // that edge.
    const T per_norm = sqrt(sides.per_norm2);
    const T along =
        kind == PairKind::vertex_face ? select(rises, -per_norm, per_norm) : select(rises, per_norm, -per_norm);
    return {Mask<T>(keeps_sign | (brackets & sides.outside)),
            Mask<T>(brackets & sides.inside),
            brackets,
            lower,
            upper,
            sides.u,
            sides.v,
            along * n};
  }

  const PairMotion<T>& step;
  const TimeInterval<T> part;
  std::array<T, 4> cubic;
  T unit;
  Mask<T> rises, keeps_sign, falls_once;
};

namespace crossing {

template <PairKind kind, class T>
inline std::array<Crossing<T>, 2> of_two(const CrossingSearch<kind, T>& a, const CrossingSearch<kind, T>& b) {
  const auto roots = find_two_roots(a.cubic, b.cubic);
  return {a.at_root(roots[0]), b.at_root(roots[1])};
}

}  // namespace crossing

template <PairKind kind, class T>
inline Crossing<T> find_crossing(const PairMotion<T>& step, const TimeInterval<T>& part) {
  const CrossingSearch<kind, T> search(step, coplanarity_polynomial(step), part);
  if constexpr (std::is_same_v<Mask<T>, bool>)
    if (search.keeps_sign) return Crossing<T>::free();
  return search.at_root(crossing::find_root(search.cubic));
}

/// The crossings of two independent pairs. While the root of one is waited for, the other is worked on.
template <PairKind kind, class T>
inline std::array<Crossing<T>, 2> find_two_crossings(const PairMotion<T>& step_a, const TimeInterval<T>& part_a,
                                                     const PairMotion<T>& step_b, const TimeInterval<T>& part_b) {
  return crossing::of_two(CrossingSearch<kind, T>(step_a, coplanarity_polynomial(step_a), part_a),
                          CrossingSearch<kind, T>(step_b, coplanarity_polynomial(step_b), part_b));
}

/// As find_crossing, where one crossing is not enough. The part is cut where the cubic turns. The first half that is
/// not free gives the answer.
template <PairKind kind, class T>
inline Crossing<T> find_crossing_in_halves(const PairMotion<T>& step, const TimeInterval<T>& part) {
  const auto whole = coplanarity_polynomial(step);
  const T s = crossing::turning_point(restrict_to(whole, part.t_in, part.t_out));
  const T cut = min(max((T(1) - s) * part.t_in + s * part.t_out, part.t_in), part.t_out);
  const TimeInterval<T> parts[] = {{part.t_in, cut}, {cut, part.t_out}};
  auto halves =
      crossing::of_two(CrossingSearch<kind, T>(step, whole, parts[0]), CrossingSearch<kind, T>(step, whole, parts[1]));
  for (std::size_t i = 0; i < 2; ++i)
    if (auto& c = halves[i]; any(!(c.is_free | c.touches)))
      c.is_free = c.is_free | Ncf::proves_free<kind>(restrict_to(step, parts[i].t_in, parts[i].t_out));
  const auto &a = halves[0], &b = halves[1];
  const auto pick = [&](const T& first, const T& second) { return select(a.is_free, second, first); };
  const Mask<T> touches = (a.touches & !a.is_free) | (a.is_free & b.touches);
  return {Mask<T>(a.is_free & b.is_free),
          touches,
          touches,
          pick(a.lower, b.lower),
          pick(a.upper, b.upper),
          pick(a.u, b.u),
          pick(a.v, b.v),
          {pick(a.normal.x, b.normal.x), pick(a.normal.y, b.normal.y), pick(a.normal.z, b.normal.z)}};
}

}  // namespace tamis
