#include "solve/apart_times.hpp"

#include <limits>

#include "solve/distance_along.hpp"

namespace tamis {
namespace {

using Vec = Vec3<double>;

using error_bounds::kRoundoff;
constexpr double kNever = std::numeric_limits<double>::infinity();

double largest_component(const Vec& v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

}  // namespace

double first_root(double c0, double c1, double c2) {
  if (!(c0 > 0)) return 0;
  // 2 c0 / (sqrt(c1^2 - 4 c0 c2) - c1) with each rounding taken the way that makes it smaller.
  const double square = c1 * c1, product = 4 * c0 * c2;
  const double discriminant = square - product + 8 * kRoundoff * (square + abs(product));
  if (discriminant < 0) return kNever;
  const double root = std::sqrt(discriminant);
  const double divisor = root - c1 + 8 * kRoundoff * (root + abs(c1));
  return divisor > 0 ? 2 * c0 / divisor * (1 - 4 * kRoundoff) : divisor <= 0 ? kNever : 0;
}

template <PairKind kind>
ApartTimes AxisClip<kind>::around(double now, const TurningAxis& axis) const {
  const double inverse_size = 1 / largest_component(axis.direction);
  const Vec n = inverse_size * axis.direction, turn = inverse_size * axis.turn;
  const double turning = largest_component(turn), error = kRoundoff * size_ + error_bounds::underflow<double>;
  // The axis' length is at most |n| + (n.turn / |n|) x + (turn.turn / 2|n|) x^2, x = t - now: a root lies below its
  // tangent.
  const double length = std::sqrt(dot(n, n));
  const double threshold = separation_ * length * (1 + 8 * kRoundoff) + error_bounds::kAxisNow * error;
  const double slope = separation_ * (dot(n, turn) / length), bend = separation_ * (dot(turn, turn) / (2 * length));
  const double drift = error_bounds::kAxisLater * error * (1 + turning);
  double later = turning > 0 ? 1 / turning : kNever, before = later;
  for (const auto& corner : corners_) {
    const Vec at = at_time(corner, now), velocity = corner.at1 - corner.at0;
    const double c0 = dot(n, at) - threshold, c1 = dot(n, velocity) + dot(turn, at) - slope;
    const double c2 = dot(turn, velocity) - bend;
    later = min(later, first_root(c0, c1 - drift, c2));
    before = min(before, first_root(c0, -c1 - drift, c2));
  }
  if (!(later > 0)) return {2, -1};
  return {(now - before) * (1 + 4 * kRoundoff), (now + later) * (1 - 4 * kRoundoff)};
}

template <PairKind kind>
double AxisClip<kind>::distance_along(double now, const Vec& direction) const {
  std::array<Vec, std::tuple_size_v<decltype(corners_)>> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = at_time(corners_[i], now);
  return tamis::distance_along(corners, direction, size_);
}

template class AxisClip<PairKind::vertex_face>;
template class AxisClip<PairKind::edge_edge>;
template class AxisClip<PairKind::vertex_edge>;
template class AxisClip<PairKind::vertex_vertex>;

}  // namespace tamis
