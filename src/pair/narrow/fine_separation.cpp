// When a pair first comes within its separation, sharpened in double-double where doubles give too wide a bracket.
#include <algorithm>
#include <cmath>

#include "numbers/assert.hpp"
#include "numbers/scale.hpp"
#include "pair/distance/orthogonal_axis.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

using Fine = DoubleDouble;
using FineVec = Vec3<Fine>;

/// 1 + `roundings` u.
Fine one_and(double roundings) { return {1, roundings * error_bounds::unit_roundoff<Fine>}; }

/// The distance at one time, in double-double.
struct FineDistance {
  double time;
  FineVec e, f, d;
  ClosestPoints rough;  ///< the closest points in doubles
  FineVec gap;          ///< between points of the features: their weights are legal
  double excess;        ///< of the squared gap over the squared separation, not certified
};

/// The arithmetic that finds closest points: doubles, or where these are too coarse double-double, at thrice the cost.
enum class WeightsIn { doubles, double_doubles };

template <PairKind kind, WeightsIn weights>
class FineSearch {
 public:
  FineSearch(const PairMotion<Fine>& fine, const PairMotion<double>& m)
      : fine_(fine), m_(m), size_(fine.size_d + fine.size_e + fine.size_f) {}

  /// Newton's method, from the middle of the bracket until its ends are neighbouring doubles.
  std::optional<Decision> run(TimeInterval<double> bracket) const {
    constexpr int kMaxIterations = 8;
    const double start = bracket.t_in;
    std::optional<FineDistance> before, after;
    double t = start + 0.5 * (bracket.t_out - start);
    for (int iterations = 0; iterations < kMaxIterations; ++iterations) {
      if (!(t > bracket.t_in && t < bracket.t_out)) break;
      const FineDistance now = distance_at(t);
      const double closer = 2 * dot(rounded(now.gap), velocity(now.rough)), next = t - now.excess / closer;
      const bool is_before = now.excess > 0;
      (is_before ? before : after) = now;
      (is_before ? bracket.t_in : bracket.t_out) = t;
      if (before && after && std::nextafter(before->time, 2.0) == after->time) {
        if (was_apart(*before, start) && is_within(*after))
          return Decision{Verdict::touches, bracket.t_in, bracket.t_out};
        break;
      }
      t = next != t ? next : std::nextafter(t, is_before ? 2.0 : -1.0);
    }
    return {};
  }

 private:
  /// Moves points that only rounding keeps off a corner or a side onto it. Else their axis would be the axis of the
  /// inside. Afterwards weights on the side opposite the first corner add up to exactly 1, other weights to less.
  static ClosestPoints snapped(ClosestPoints p) {
    constexpr double kNear = 0x1p-44;
    for (double* weight : {&p.u, &p.v}) *weight = *weight < kNear ? 0 : *weight > 1 - kNear ? 1 : *weight;
    if (kind == PairKind::vertex_face && p.u + p.v > 1 - kNear) {
      double &larger = p.u < p.v ? p.v : p.u, &smaller = p.u < p.v ? p.u : p.v;
      larger = std::max(larger, 0.5);
      smaller = 1 - larger;  // exactly
    }
    return p;
  }

  FineDistance distance_at(double t) const {
    FineDistance s{t, at_time(fine_.e, Fine(t)), at_time(fine_.f, Fine(t)), at_time(fine_.d, Fine(t)), {}, {}, 0};
    if constexpr (weights == WeightsIn::doubles) {
      s.rough = snapped(closest_points<kind>(rounded(s.e), rounded(s.f), rounded(s.d)));
      s.gap = gap_at<kind>(s.e, s.f, s.d, Fine(s.rough.u), Fine(s.rough.v));
    } else {
      const auto closest = closest_points<kind>(s.e, s.f, s.d);
      s.rough = snapped({closest.u.high, closest.v.high, rounded(closest.gap)});
      s.gap = closest.gap;
    }
    s.excess = (dot(s.gap, s.gap) - fine_.separation * fine_.separation).high;
    return s;
  }

  /// The velocity of the gap between the closest points, were their weights fixed.
  Vec3<double> velocity(const ClosestPoints& p) const {
    return gap_at<kind>(m_.e.at1, m_.f.at1, m_.d.at1, p.u, p.v) - gap_at<kind>(m_.e.at0, m_.f.at0, m_.d.at0, p.u, p.v);
  }

  /// Certified: the closest points are within the separation.
  bool is_within(const FineDistance& s) const {
    const Fine least = fine_.separation - error_bounds::bound<Fine>(error_bounds::kGap, size_);
    return least > Fine(0) && dot(s.gap, s.gap) * one_and(8) < least * least * one_and(-8);
  }

  /// Certified: the pair is apart from `start` until s.time. Along the axis of the closest points all corners lie
  /// beyond the separation at s.time, and lay beyond it all the time since `start` (AxisClip::was_beyond).
  bool was_apart(const FineDistance& s, double start) const {
    const Fine zero(0);
    const FineVec axis = orthogonal_gap<kind>(s.e, s.f, ClosestPointsOf<Fine>{s.rough.u, s.rough.v, s.gap});
    const double scale = scale_below_one(largest_component(rounded(axis)));
    const FineVec n = scaled(scale, axis);
    const Fine error = error_bounds::bound<Fine>(error_bounds::kAxisNow, size_);
    const Fine reach = fine_.separation * fine_.separation * dot(n, n) * one_and(16);
    for (const FineVec& corner : difference_corners<kind>(s.e, s.f, s.d)) {
      const Fine along = dot(n, corner) - error;
      if (!(along > zero && along * along * one_and(-8) > reach)) return false;
    }
    const Vec3<double> turn = orthogonal_axis<kind>(m_, s.time, s.rough).turn;
    return AxisClip<kind, double>(m_).was_beyond(s.time, {rounded(n), scale * turn}, s.time - start);
  }

  const PairMotion<Fine>& fine_;
  const PairMotion<double>& m_;
  const Fine size_;
};

}  // namespace

std::optional<Decision> first_within_finely(const PairInStep& pair, const TimeInterval<double>& bracket) {
  TAMIS_ASSERT(is_part_of_step(bracket));
  const PairMotion<Fine> fine = make_fine_motion(pair);
  return with_kind(pair.kind, [&](auto kind) {
    const auto decision = FineSearch<kind(), WeightsIn::doubles>(fine, pair.motion).run(bracket);
    return decision ? decision : FineSearch<kind(), WeightsIn::double_doubles>(fine, pair.motion).run(bracket);
  });
}

}  // namespace tamis
