#include "motion/make_motion.hpp"

#include <algorithm>

#include "motion/pair_kinds.hpp"
#include "numerics/scale.hpp"

namespace tamis {
namespace {

Moving<double> scaled(const Moving<double>& v, double scale) { return {scale * v.at0, scale * v.at1}; }

Moving<double> difference(const PairPoints& points, VertexDifference v) {
  const auto at = [&](const std::array<Point, 4>& p) {
    const Point &to = p[static_cast<std::size_t>(v.to)], &from = p[static_cast<std::size_t>(v.from)];
    return Vec3<double>{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  };
  return {at(points.start), at(points.end)};
}

}  // namespace

PairMotion<double> make_motion(PairKind kind, const PairPoints& points, double separation) {
  const SpanningVectors vectors = spanning_vectors(kind);
  const auto e = difference(points, vectors.e), f = difference(points, vectors.f), d = difference(points, vectors.d);
  const double scale = scale_below_one(std::max({largest(e), largest(f), largest(d)}));
  return {scaled(e, scale),   scaled(f, scale),   scaled(d, scale),  scale * largest(e),
          scale * largest(f), scale * largest(d), scale * separation};
}

}  // namespace tamis
