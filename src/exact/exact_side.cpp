#include "exact/exact_side.hpp"

#include "exact/algebraic_time.hpp"
#include "exact/moving_polygon.hpp"
#include "motion/pair_kinds.hpp"
#include "numerics/assert.hpp"

namespace tamis {

int side_just_before(PairKind kind, const PairPoints& points, double time) {
  TAMIS_ASSERT(can_cross(kind) && is_finite(points) && 0 <= time && time <= 1);
  // The normal of edges' polygon is -(e x f), and its corners lead from the first edge to the second: two changes of
  // sign.
  const MovingPolygon polygon = stretched_polygon(kind, points);
  auto k = IntegerPolynomial::from_bernstein(coplanarity_polynomial(polygon.corner(0), normal_polynomial(polygon)));
  AlgebraicTime now = AlgebraicTime::exactly(shortest_cell_at(time));
  for (int before = 1; !k.is_zero(); before = -before, k = k.derivative())
    if (const int sign = now.sign_of(k)) return before * sign;
  return 0;
}

}  // namespace tamis
