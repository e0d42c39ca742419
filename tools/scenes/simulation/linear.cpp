#include "scenes/simulation/linear.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tamis::simulation {
namespace {

double cotangent(const Vec& a, const Vec& b) { return a.dot(b) / a.cross(b).norm(); }

}  // namespace

Bend make_bend(const std::array<Index, 4>& vertices, const Points& rest, double stiffness) {
  const auto along = [&](std::size_t from, std::size_t to) -> Vec {
    return rest.col(vertices[to]) - rest.col(vertices[from]);
  };
  const Vec edge = along(0, 1);
  const double at0_2 = cotangent(edge, along(0, 2)), at0_3 = cotangent(edge, along(0, 3));
  const double at1_2 = cotangent(-edge, along(1, 2)), at1_3 = cotangent(-edge, along(1, 3));
  const double area = 0.5 * (edge.cross(along(0, 2)).norm() + edge.cross(along(0, 3)).norm());
  return {vertices, {at1_2 + at1_3, at0_2 + at0_3, -at0_2 - at1_2, -at0_3 - at1_3}, area / (3 * stiffness)};
}

Attachment make_attachment(const std::array<Index, 5>& vertices, const Points& rest) {
  const Vec origin = rest.col(vertices[1]);
  Eigen::Matrix3d sides;
  for (int i = 0; i < 3; ++i) sides.col(i) = rest.col(vertices[static_cast<std::size_t>(i) + 2]) - origin;
  const Vec b = sides.inverse() * (rest.col(vertices[0]) - origin);
  return {vertices, {-1, 1 - b.sum(), b[0], b[1], b[2]}, 0};
}

}  // namespace tamis::simulation
