// Distances at one time in integers: the point of the difference polygon nearest to the origin.
#pragma once
#include <array>

#include "exact/moving_polygon.hpp"
#include "numerics/assert.hpp"
#include "numerics/wide_double.hpp"

namespace tamis {

/// REQUIRES, whoever reads its value: below > 0.
struct Fraction {
  Integer above, below{1};
};

/// Off by 2^-51 of itself at most. REQUIRES: below > 0.
inline WideDouble wide(const Fraction& a) {
  TAMIS_ASSERT(a.below.sign() > 0);
  return WideDouble::of(a.above) / WideDouble::of(a.below);
}

struct NearestPoint {
  struct Plane {
    Vec3<Integer> normal;  ///< zero: there is no plane
    Integer square;        ///< of the normal
    Integer height;        ///< of the plane along the normal, times its length; of a point inside alone
    /// By side, times the normal's square: the share of the polygon's parallelogram between it and the foot of the
    /// perpendicular; negative where that is beyond the side.
    std::array<Integer, 4> within;
  };

  Fraction square;       ///< of the distance, in the unit 4^exponent of the polygon
  std::size_t side = 0;  ///< on the side from corner `side` to the next, at `along`; or, if is_inside, off the sides
  Fraction along;
  bool is_inside = false;
  Plane plane;
};

/// Of the polygon at t=0.
NearestPoint nearest_point(const MovingPolygon& polygon);

/// As NearPair has them, each rounded by a few u of itself; `direction` along the gap (distance/closest.hpp). Where
/// there is none the one that it had before, as the features came together; of those that did not the normal, or zero
/// where there is none.
struct ExactDistance {
  double distance, u, v;
  Vec3<double> direction;
};

/// REQUIRES, both: finite coordinates, `time` in [0,1].
ExactDistance exact_distance(PairKind kind, const PairPoints& points, double time = 0);

/// Along e x f (motion/pair_motion.hpp), of unit length; zero if that is.
Vec3<double> exact_normal(PairKind kind, const PairPoints& points, double time);

}  // namespace tamis
