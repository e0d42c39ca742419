#include "paper/bounds/principal_axes.hpp"

#include <cmath>

namespace tamis::lab {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// One Jacobi rotation in the plane of p and q (Golub, Van Loan, 8.5).
void rotate(Matrix& a, Matrix& axes, std::size_t p, std::size_t q) {
  if (std::fabs(a[p][q]) <= 1e-17 * (std::fabs(a[p][p]) + std::fabs(a[q][q]))) return;
  const double theta = 0.5 * (a[q][q] - a[p][p]) / a[p][q];
  const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double kp = a[k][p], kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double pk = a[p][k], qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
    const double ap = axes[p][k], aq = axes[q][k];
    axes[p][k] = c * ap - s * aq;
    axes[q][k] = s * ap + c * aq;
  }
}

Vec3<double> normalized(const Vec3<double>& v) { return (1 / std::sqrt(dot(v, v))) * v; }

}  // namespace

std::array<Vec3<double>, 3> principal_axes(const SymmetricMatrix& m) {
  constexpr int kSweeps = 5;
  Matrix a{{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}};
  Matrix axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(a, axes, 0, 1);
    rotate(a, axes, 0, 2);
    rotate(a, axes, 1, 2);
  }
  // Each rotation keeps the axes orthonormal up to a few roundings; this removes the accumulated error.
  const Vec3<double> x = normalized({axes[0][0], axes[0][1], axes[0][2]}), y{axes[1][0], axes[1][1], axes[1][2]};
  const Vec3<double> z = normalized(cross(x, y));
  return {x, cross(z, x), z};
}

}  // namespace tamis::lab
