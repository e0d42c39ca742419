#include "scenes/simulation/touch.hpp"

#include <algorithm>

#include "scenes/simulation/nearest.hpp"

namespace tamis::simulation {
namespace {

/// Share of the way to its first contact at which a pair is looked at.
constexpr double kJustBefore = 0.9;
/// Share of the missing thickness that is regained in a step.
constexpr double kRecovery = 0.1;

Corners corners(const std::array<Index, 4>& v, const Points& points) {
  Corners result;
  for (int i = 0; i < 4; ++i) result.col(i) = points.col(v[static_cast<std::size_t>(i)]);
  return result;
}

}  // namespace

Touch make_touch(const Contact& contact, const Points& start, const Points& end, double thickness) {
  const auto from = corners(contact.vertices, start), to = corners(contact.vertices, end);
  const double t = kJustBefore * contact.toi_lower;
  const Corners then = (1 - t) * from + t * to;
  const Eigen::Vector4d weights = nearest_weights(contact.kind, then);
  const Vec gap = then * weights;
  const double length = gap.norm();
  const Vec normal = length > 0 ? Vec(gap / length) : Vec(contact.normal.data());
  const double at_start = normal.dot(from * weights);
  const double wanted = at_start < thickness ? at_start + kRecovery * (thickness - at_start) : thickness;
  return {contact.vertices, weights, normal, wanted};
}

void project(const Touch& touch, Particles& particles, const Points& start, double friction) {
  Points& x = particles.position;
  const Vec between = corners(touch.vertices, x) * touch.weights;
  const double lack = touch.gap - touch.normal.dot(between);
  if (lack <= 0) return;
  double weight = 0;
  for (int i = 0; i < 4; ++i)
    weight += touch.weights[i] * touch.weights[i] * particles.inverse_mass[touch.vertices[static_cast<std::size_t>(i)]];
  if (weight == 0) return;
  Vec slip = between - corners(touch.vertices, start) * touch.weights;
  slip -= touch.normal.dot(slip) * touch.normal;
  const double slid = slip.norm();
  const double held = slid > 0 ? std::min(1.0, friction * lack / slid) : 0;
  const Vec move = lack * touch.normal - held * slip;
  for (int i = 0; i < 4; ++i) {
    const Index v = touch.vertices[static_cast<std::size_t>(i)];
    x.col(v) += particles.inverse_mass[v] * touch.weights[i] / weight * move;
  }
}

}  // namespace tamis::simulation
