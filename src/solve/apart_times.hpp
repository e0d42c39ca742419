// When does an axis keep a pair apart? The slab clip on one axis chosen for the pair, which may turn with it. On a
// fixed axis the two features close in linearly, corner by corner; on one that turns at a constant rate, quadratically.
// Both are sharper than a bound on the speed of the pair.
#pragma once
#include <cmath>

#include "numerics/error_bounds.hpp"
#include "solve/difference_corners.hpp"

namespace tamis {

/// An open interval of time; empty if to <= from. It may reach beyond the step.
struct ApartTimes {
  double from, to;
  bool contains(double t) const { return from < t && t < to; }
};

/// n(t) = direction + (t - now) turn. Of any length, not zero at `now`.
struct TurningAxis {
  Vec3<double> direction;
  Vec3<double> turn{0, 0, 0};
};

/// A lower bound, beyond all rounding, of the first x > 0 at which c0 + c1 x + c2 x^2 <= 0; 0 if c0 <= 0, and infinite
/// if there is none.
double first_root(double c0, double c1, double c2);

/// REQUIRES: `m` is the motion of the whole step, its sizes are finite.
template <PairKind kind>
class AxisClip {
 public:
  explicit AxisClip(const PairMotion<double>& m)
      : corners_(difference_corners<kind>(m)), separation_(m.separation), size_(m.size_d + m.size_e + m.size_f) {}

  /// Times around `now` at which, proven, all corners lie beyond the separation along the axis; empty if not even
  /// `now`.
  ApartTimes around(double now, const TurningAxis& axis) const;
  /// A lower bound, beyond all rounding, of the distance at `now` by a direction of any length; 0 if it proves none.
  double distance_along(double now, const Vec3<double>& direction) const;

 private:
  decltype(difference_corners<kind>(PairMotion<double>{})) corners_;
  double separation_, size_;
};

extern template class AxisClip<PairKind::vertex_face>;
extern template class AxisClip<PairKind::edge_edge>;
extern template class AxisClip<PairKind::vertex_edge>;
extern template class AxisClip<PairKind::vertex_vertex>;

}  // namespace tamis
