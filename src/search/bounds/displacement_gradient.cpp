#include "search/bounds/displacement_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace tamis {
namespace {

using Vec = Vec3<double>;
using Columns = std::array<Vec, 3>;

/// Columns of I + t G.
Columns columns_at(const DisplacementGradient& g, double t) {
  const auto& [a, b, c] = g.rows;
  return {{{1 + t * a.x, t * b.x, t * c.x}, {t * a.y, 1 + t * b.y, t * c.y}, {t * a.z, t * b.z, 1 + t * c.z}}};
}

/// The symmetric part of A^T B: x -> (A x).(B x).
SymmetricMatrix product(const Columns& a, const Columns& b) {
  const auto mean = [&](std::size_t i, std::size_t j) { return 0.5 * (dot(a[i], b[j]) + dot(a[j], b[i])); };
  return {mean(0, 0), mean(1, 1), mean(2, 2), mean(0, 1), mean(0, 2), mean(1, 2)};
}

/// True if all eigenvalues are above `bound`. All pivots of Gauss' elimination on m - bound I must be positive.
bool exceed(const SymmetricMatrix& m, double bound) {
  const double first = m.xx - bound;
  if (!(first > 0)) return false;
  const double second = m.yy - bound - m.xy * m.xy / first, side = m.yz - m.xy * m.xz / first;
  if (!(second > 0)) return false;
  return m.zz - bound - m.xz * m.xz / first - side * side / second > 0;
}

/// A lower bound of `most` and all eigenvalues, within 2^-12 of `most`. Positive pivots prove this up to a few
/// roundings of the trace (Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.3), far below 2^-30 for a
/// matrix whose norm is below 2^10. For others the bound is 0.
double least_eigenvalue(const SymmetricMatrix& m, double most) {
  if (!(m.xx + m.yy + m.zz < 0x1p10)) return 0;
  if (exceed(m, most)) return std::max(most - 0x1p-30, 0.0);
  double low = 0, high = most;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    (exceed(m, middle) ? low : high) = middle;
  }
  return std::max(low - 0x1p-30, 0.0);
}

/// Gershgorin: the largest row sum of |m|.
double greatest_eigenvalue(const SymmetricMatrix& m) {
  const double xy = std::fabs(m.xy), xz = std::fabs(m.xz), yz = std::fabs(m.yz);
  return std::max({m.xx + xy + xz, m.yy + xy + yz, m.zz + xz + yz});
}

Columns as_rows(const SymmetricMatrix& m) { return {{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}}; }

/// x -> M^-1 x, by cofactors.
Columns inverse(const SymmetricMatrix& m) {
  const auto [a, b, c] = as_rows(m);
  const double scale = 1 / dot(a, cross(b, c));
  return {scale * cross(b, c), scale * cross(c, a), scale * cross(a, b)};
}

}  // namespace

/// |(I + t G) x|^2 is quadratic in t. In each part of the time it is at least its least Bernstein coefficient. It is
/// convex, so largest at an end. The last part comes first. Mostly it has the least, and one test shows that the others
/// exceed it.
StretchBounds stretch_bounds(const DisplacementGradient& gradient) {
  constexpr int kParts = 4;
  double least = 1;
  const Columns end = columns_at(gradient, 1);
  Columns to = end;
  for (int i = kParts - 1; i >= 0; --i) {
    const Columns from = columns_at(gradient, i / static_cast<double>(kParts));
    least = least_eigenvalue(product(to, to), least);
    least = least_eigenvalue(product(from, to), least);
    to = from;
  }
  const double greatest = std::max(1.0, greatest_eigenvalue(product(end, end)));
  return {std::sqrt(least) * (1 - 0x1p-50), std::sqrt(greatest) * (1 + 0x1p-48)};
}

GradientFit fit_gradient(const PackedMotion& motion, std::span<const Index> vertices, std::size_t stride) {
  constexpr double kRidge = 0x1p-20;  // points in a plane, or on a line, tell no gradient out of it
  double count = 0;
  Vec places{}, displacements{};
  SymmetricMatrix squares;
  std::array<Vec, 3> products{};  // [i]: displacement[i] times place
  const auto add_product = [&](const Vec& u, const Vec& x) {
    products = {products[0] + u.x * x, products[1] + u.y * x, products[2] + u.z * x};
  };
  for (std::size_t i = 0; i < vertices.size(); i += stride) {
    if (motion.is_outlier(vertices[i])) continue;
    ++count;
    const PackedVertex& vertex = motion.vertices[static_cast<std::size_t>(vertices[i])];
    const Vec place = motion.frame.place(vertex), displacement = motion.frame.displacement(vertex);
    places = places + place;
    displacements = displacements + displacement;
    squares.add_square(place, 1);
    add_product(displacement, place);
  }
  GradientFit result;
  if (!(count > 0)) return result;
  result.mean_position = (1 / count) * places;
  result.mean_displacement = (1 / count) * displacements;
  squares.add_square(result.mean_position, -count);
  const double ridge = kRidge * (squares.xx + squares.yy + squares.zz);
  if (!(ridge > 0)) return result;  // any gradient fits a point
  for (double* diagonal : {&squares.xx, &squares.yy, &squares.zz}) *diagonal += ridge;
  const DisplacementGradient solve{inverse(squares)};
  add_product(-result.mean_displacement, places);
  for (std::size_t i = 0; i < 3; ++i) result.gradient.rows[i] = solve.at(products[i]);
  return result;
}

}  // namespace tamis
