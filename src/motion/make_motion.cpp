#include "motion/make_motion.hpp"

#include <algorithm>

#include "numerics/scale.hpp"

namespace tamis {
namespace {

Vec3<double> difference(const Point& to, const Point& from) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

Moving<double> scaled(const Moving<double>& v, double scale) { return {scale * v.at0, scale * v.at1}; }

}  // namespace

PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation) {
  const auto moving = [&](std::size_t to, std::size_t from) {
    return Moving<double>{difference(points.start[to], points.start[from]),
                          difference(points.end[to], points.end[from])};
  };
  const bool is_vf = kind == PairKind::vertex_face;
  const Moving<double> e = is_vf ? moving(2, 1) : moving(1, 0);
  const Moving<double> f = is_vf ? moving(3, 1) : moving(3, 2);
  const Moving<double> d = is_vf ? moving(0, 1) : moving(2, 0);
  const double scale = scale_below_one(std::max({largest(e), largest(f), largest(d)}));
  return {scaled(e, scale),   scaled(f, scale),   scaled(d, scale),  scale * largest(e),
          scale * largest(f), scale * largest(d), scale * separation};
}

}  // namespace tamis
