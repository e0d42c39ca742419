#include "scenes/simulation/nearest.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace tamis::simulation {
namespace {

using Vec = Eigen::Vector3d;
using Weights = Eigen::Vector4d;

/// Parameter of the point of a + s (b - a), s in [0, 1], nearest to p.
double on_segment(const Vec& p, const Vec& a, const Vec& b) {
  const double length2 = (b - a).squaredNorm();
  return length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0;
}

Weights on_face(double u, double v) { return {1, u + v - 1, -u, -v}; }
Weights on_edges(double u, double v) { return {1 - u, u, v - 1, -v}; }

void keep_nearer(const Corners& c, Weights& best, const Weights& other) {
  if ((c * other).squaredNorm() < (c * best).squaredNorm()) best = other;
}

Weights vertex_face(const Corners& c) {
  const Vec p = c.col(0), e = c.col(2) - c.col(1), f = c.col(3) - c.col(1), d = p - c.col(1), n = e.cross(f);
  const double u = d.cross(f).dot(n), v = e.cross(d).dot(n), norm2 = n.squaredNorm();
  if (norm2 > 0 && u >= 0 && v >= 0 && u + v <= norm2) return on_face(u / norm2, v / norm2);
  Weights best = on_face(on_segment(p, c.col(1), c.col(2)), 0);
  keep_nearer(c, best, on_face(0, on_segment(p, c.col(1), c.col(3))));
  const double s = on_segment(p, c.col(2), c.col(3));
  keep_nearer(c, best, on_face(1 - s, s));
  return best;
}

Weights edge_edge(const Corners& c) {
  const Vec e = c.col(1) - c.col(0), f = c.col(3) - c.col(2), d = c.col(2) - c.col(0), n = e.cross(f);
  const double u = d.cross(f).dot(n), v = d.cross(e).dot(n), norm2 = n.squaredNorm();
  if (norm2 > 0 && std::min(u, v) >= 0 && std::max(u, v) <= norm2) return on_edges(u / norm2, v / norm2);
  Weights best = on_edges(0, on_segment(c.col(0), c.col(2), c.col(3)));
  keep_nearer(c, best, on_edges(1, on_segment(c.col(1), c.col(2), c.col(3))));
  keep_nearer(c, best, on_edges(on_segment(c.col(2), c.col(0), c.col(1)), 0));
  keep_nearer(c, best, on_edges(on_segment(c.col(3), c.col(0), c.col(1)), 1));
  return best;
}

}  // namespace

Eigen::Vector4d nearest_weights(PairKind kind, const Corners& corners) {
  return kind == PairKind::vertex_face ? vertex_face(corners) : edge_edge(corners);
}

}  // namespace tamis::simulation
