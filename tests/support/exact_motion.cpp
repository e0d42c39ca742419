#include "support/exact_motion.hpp"

namespace tamis::test {

PairMotion<Rational> exact_motion(PairKind kind, const oracle::Motion& motion, const Rational& scale) {
  const auto vector = [&](const Point& to, const Point& from) {
    return Vec3<Rational>{scale * (Rational(to[0]) - Rational(from[0])), scale * (Rational(to[1]) - Rational(from[1])),
                          scale * (Rational(to[2]) - Rational(from[2]))};
  };
  const auto moving = [&](std::size_t to, std::size_t from) {
    return Moving<Rational>{vector(motion.start[to], motion.start[from]), vector(motion.end[to], motion.end[from])};
  };
  if (kind == PairKind::vertex_face) return {moving(2, 1), moving(3, 1), moving(0, 1), {}, {}, {}};
  if (kind == PairKind::edge_edge) return {moving(1, 0), moving(3, 2), moving(2, 0), {}, {}, {}};
  return {moving(kind == PairKind::vertex_edge ? 2 : 1, 1), moving(1, 1), moving(0, 1), {}, {}, {}};
}

}  // namespace tamis::test
