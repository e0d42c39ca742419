#include "bounds/displacement_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace tamis {
namespace {

using Vec = Vec3<double>;
using Columns = std::array<Vec, 3>;

/// Of I + t G.
Columns columns_at(const DisplacementGradient& g, double t) {
  const auto& [a, b, c] = g.rows;
  return {{{1 + t * a.x, t * b.x, t * c.x}, {t * a.y, 1 + t * b.y, t * c.y}, {t * a.z, t * b.z, 1 + t * c.z}}};
}

/// The symmetric part of A^T B: x -> (A x).(B x).
SymmetricMatrix product(const Columns& a, const Columns& b) {
  const auto mean = [&](std::size_t i, std::size_t j) { return 0.5 * (dot(a[i], b[j]) + dot(a[j], b[i])); };
  return {mean(0, 0), mean(1, 1), mean(2, 2), mean(0, 1), mean(0, 2), mean(1, 2)};
}

/// Are all eigenvalues above `bound`? By the pivots of Gauss' elimination.
bool exceed(const SymmetricMatrix& m, double bound) {
  const double first = m.xx - bound;
  if (!(first > 0)) return false;
  const double second = m.yy - bound - m.xy * m.xy / first, side = m.yz - m.xy * m.xz / first;
  if (!(second > 0)) return false;
  return m.zz - bound - m.xz * m.xz / first - side * side / second > 0;
}

/// A lower bound of the eigenvalues and of `most`, to 2^-12. Elimination that ends with positive pivots proves what it
/// says up to a few roundings of the trace (Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.3), of a
/// matrix whose norm is below 2^10 far below 2^-30; others give 0.
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

/// Gershgorin: rows of |m|.
double greatest_eigenvalue(const SymmetricMatrix& m) {
  const double xy = std::fabs(m.xy), xz = std::fabs(m.xz), yz = std::fabs(m.yz);
  return std::max({m.xx + xy + xz, m.yy + xy + yz, m.zz + xz + yz});
}

Columns rows_of(const SymmetricMatrix& m) { return {{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}}; }

/// x -> M^-1 x, by cofactors.
Columns inverse(const SymmetricMatrix& m) {
  const auto [a, b, c] = rows_of(m);
  const double scale = 1 / dot(a, cross(b, c));
  return {scale * cross(b, c), scale * cross(c, a), scale * cross(a, b)};
}

}  // namespace

/// |(I + t G) x|^2 is quadratic in t: in each part of the time at least the least of its Bernstein coefficients; and
/// convex, so largest at an end. Mostly the last part has the least, and the others are found to exceed it at once.
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

void DisplacementMoments::add(const Vec& place, const Vec& way, double count) {
  DisplacementMoments one;
  one.count_ = count;
  one.place_ = count * place;
  one.way_ = count * way;
  one.place2_.add_square(place, count);
  one.way_place_ = {(count * way.x) * place, (count * way.y) * place, (count * way.z) * place};
  one.way2_ = count * dot(way, way);
  *this += one;
}

DisplacementMoments& DisplacementMoments::operator+=(const DisplacementMoments& other) {
  count_ += other.count_;
  place_ = place_ + other.place_;
  way_ = way_ + other.way_;
  place2_ += other.place2_;
  for (std::size_t i = 0; i < 3; ++i) way_place_[i] = way_place_[i] + other.way_place_[i];
  way2_ += other.way2_;
  return *this;
}

double DisplacementMoments::displacement2() const {
  return count_ > 0 ? std::max(0.0, way2_ - dot(way_, (1 / count_) * way_)) : 0;
}

GradientFit DisplacementMoments::fit() const {
  constexpr double kRidge = 0x1p-20;  // what lies in a plane, or on a line, has no gradient out of it
  GradientFit result;
  if (!(count_ > 0)) return result;
  result.middle = (1 / count_) * place_;
  result.way = (1 / count_) * way_;
  result.residual2 = result.displacement2 = displacement2();
  SymmetricMatrix squares = place2_;
  squares.add_square(result.middle, -count_);
  const double ridge = kRidge * (squares.xx + squares.yy + squares.zz);
  if (!(ridge > 0)) return result;  // a point turns as one likes
  SymmetricMatrix ridged = squares;
  for (double* diagonal : {&ridged.xx, &ridged.yy, &ridged.zz}) *diagonal += ridge;
  const DisplacementGradient solve{inverse(ridged)}, spread{rows_of(squares)};
  const Vec& way = result.way;
  const std::array<double, 3> ways{way.x, way.y, way.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec products = way_place_[i] - ways[i] * place_;
    const Vec row = result.gradient.rows[i] = solve.at(products);
    result.residual2 += dot(row, spread.at(row)) - 2 * dot(row, products);
  }
  result.residual2 = std::max(0.0, result.residual2);
  return result;
}

DisplacementMoments moments_of(const Step& step, const BoxFrame& frame, std::span<const Index> vertices,
                               std::size_t stride) {
  DisplacementMoments moments;
  const std::size_t looked_at = (vertices.size() + stride - 1) / stride;  // perhaps none
  const double count = static_cast<double>(vertices.size()) / static_cast<double>(looked_at);
  for (std::size_t i = 0; i < vertices.size(); i += stride)
    moments.add(frame.place(step.start, vertices[i]), frame.displacement(step, vertices[i]), count);
  return moments;
}

}  // namespace tamis
