#include "scenes/simulation/tetrahedron.hpp"

#include <Eigen/LU>

namespace tamis::simulation {
namespace {

Eigen::Matrix3d sides(const std::array<Index, 4>& v, const Points& points) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) result.col(i) = points.col(v[static_cast<std::size_t>(i) + 1]) - points.col(v[0]);
  return result;
}

/// Turns `q` towards the rotation nearest to `f` (Mueller, Bender, Chentanez, Macklin 2016, "A Robust Method to Extract
/// the Rotational Part of Deformations"); never a reflection.
void approach_rotation(const Eigen::Matrix3d& f, Eigen::Quaterniond& q) {
  constexpr int kSteps = 10;
  constexpr double kEnough = 1e-6;  // radians
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Matrix3d r = q.toRotationMatrix();
    Vec turn = r.col(0).cross(f.col(0)) + r.col(1).cross(f.col(1)) + r.col(2).cross(f.col(2));
    turn /= std::abs(r.cwiseProduct(f).sum()) + 1e-9;
    const double angle = turn.norm();
    if (angle < kEnough) return;
    q = Eigen::AngleAxisd(angle, turn / angle) * q;
    q.normalize();
  }
}

}  // namespace

Tetrahedron::Tetrahedron(const std::array<Index, 4>& vertices, const Points& rest, const Elasticity& elasticity)
    : vertices_(vertices),
      inverse_rest_(sides(vertices, rest).inverse()),
      rest_volume_(std::abs(sides(vertices, rest).determinant()) / 6),
      shear_compliance_(1 / (2 * elasticity.shear * rest_volume_)),
      volume_compliance_(1 / (elasticity.volume * rest_volume_)) {}

Eigen::Matrix3d Tetrahedron::deformation(const Particles& particles) const {
  return sides(vertices_, particles.position) * inverse_rest_;
}

void Tetrahedron::apply(Particles& particles, const Eigen::Matrix3d& slope, double value, double compliance,
                        double& multiplier, double dt) const {
  const Eigen::Matrix3d corners = slope * inverse_rest_.transpose();
  const Vec first = -corners.rowwise().sum();
  double weight = particles.inverse_mass[vertices_[0]] * first.squaredNorm();
  for (int i = 0; i < 3; ++i)
    weight += particles.inverse_mass[vertices_[static_cast<std::size_t>(i) + 1]] * corners.col(i).squaredNorm();
  const double change = multiplier_step(value, multiplier, compliance, weight, dt);
  multiplier += change;
  particles.position.col(vertices_[0]) += particles.inverse_mass[vertices_[0]] * change * first;
  for (int i = 0; i < 3; ++i) {
    const Index v = vertices_[static_cast<std::size_t>(i) + 1];
    particles.position.col(v) += particles.inverse_mass[v] * change * corners.col(i);
  }
}

void Tetrahedron::project(Particles& particles, double dt) {
  Eigen::Matrix3d f = deformation(particles);
  approach_rotation(f, rotation_);
  const Eigen::Matrix3d strain = f - rotation_.toRotationMatrix();
  const double size = strain.norm();
  if (size > 0) apply(particles, strain / size, size, shear_compliance_, shear_multiplier_, dt);
  f = deformation(particles);
  Eigen::Matrix3d cofactor;
  cofactor << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
  apply(particles, cofactor, f.determinant() - 1, volume_compliance_, volume_multiplier_, dt);
}

}  // namespace tamis::simulation
