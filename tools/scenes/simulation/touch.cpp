#include "scenes/simulation/touch.hpp"

#include <algorithm>

namespace tamis::simulation {
namespace {

/// One column a vertex, in the order of Contact.
using Corners = Eigen::Matrix<double, 3, 4>;

/// Share of the missing thickness that is regained in a step.
constexpr double kRecovery = 0.1;

Corners corners(const std::array<Index, 4>& v, const Points& points) {
  Corners result;
  for (int i = 0; i < 4; ++i) result.col(i) = points.col(v[static_cast<std::size_t>(i)]);
  return result;
}

Eigen::Vector4d weights_of(const Contact& c) {
  if (c.kind == PairKind::edge_edge) return {1 - c.u, c.u, c.v - 1, -c.v};
  return {1, c.u + c.v - 1, -c.u, -c.v};
}

}  // namespace

Touch make_touch(const Contact& contact, const Points& start, double thickness) {
  const Eigen::Vector4d weights = weights_of(contact);
  const Vec normal(contact.normal.data());
  const double at_start = normal.dot(corners(contact.vertices, start) * weights);
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
