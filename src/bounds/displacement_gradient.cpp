#include "bounds/displacement_gradient.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/symmetric_axes.hpp"

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

/// A lower bound of the eigenvalues and of 1, to 2^-12. Elimination that ends with positive pivots proves what it says
/// up to a few roundings of the trace (Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.3), of a
/// matrix whose norm is below 2^10 far below 2^-30; others give 0.
double least_eigenvalue(const SymmetricMatrix& m) {
  if (!(m.xx + m.yy + m.zz < 0x1p10)) return 0;
  double low = 0, high = 1;
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

/// x -> M^-1 x, by cofactors.
Columns inverse(const SymmetricMatrix& m) {
  const Vec a{m.xx, m.xy, m.xz}, b{m.xy, m.yy, m.yz}, c{m.xz, m.yz, m.zz};
  const double scale = 1 / dot(a, cross(b, c));
  return {scale * cross(b, c), scale * cross(c, a), scale * cross(a, b)};
}

/// Some of the vertices of a step, in the frame of the boxes.
class Sampled {
 public:
  Sampled(const Step& step, const BoxFrame& frame, std::span<const Index> vertices) {
    constexpr std::size_t kMost = 1024;
    const std::size_t stride = vertices.size() / kMost + 1;
    for (std::size_t i = 0; i < vertices.size(); i += stride) {
      places_.push_back(frame.place(step.start, vertices[i]));
      ways_.push_back(frame.displacement(step, vertices[i]));
    }
    middle = centre(places_);
    way = centre(ways_);
  }

  DisplacementGradient least_squares() const {
    constexpr double kRidge = 0x1p-20;  // what lies in a plane, or on a line, has no gradient out of it
    SymmetricMatrix squares;
    Columns products{};
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Vec &x = places_[i], &u = ways_[i];
      squares.add_square(x);
      products = {products[0] + u.x * x, products[1] + u.y * x, products[2] + u.z * x};
    }
    const double ridge = kRidge * (squares.xx + squares.yy + squares.zz);
    if (!(ridge > 0)) return {};  // a point turns as one likes
    for (double* diagonal : {&squares.xx, &squares.yy, &squares.zz}) *diagonal += ridge;
    const DisplacementGradient solve{inverse(squares)};
    return {{solve.at(products[0]), solve.at(products[1]), solve.at(products[2])}};
  }

  double mean_square_beside(const DisplacementGradient& gradient) const {
    double sum = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Vec rest = ways_[i] - gradient.at(places_[i]);
      sum += dot(rest, rest);
    }
    return sum / static_cast<double>(places_.size());
  }

  Vec middle, way;

 private:
  static Vec centre(std::vector<Vec>& vectors) {
    Vec mean{};
    for (const Vec& v : vectors) mean = mean + (1 / static_cast<double>(vectors.size())) * v;
    for (Vec& v : vectors) v = v - mean;
    return mean;
  }

  std::vector<Vec> places_, ways_;  ///< around their means
};

}  // namespace

/// |(I + t G) x|^2 is quadratic in t: in each part of the time at least the least of its Bernstein coefficients; and
/// convex, so largest at an end.
StretchBounds stretch_bounds(const DisplacementGradient& gradient) {
  constexpr int kParts = 4;
  double least = 1;
  Columns from = columns_at(gradient, 0);
  for (int i = 1; i <= kParts; ++i) {
    const Columns to = columns_at(gradient, i / static_cast<double>(kParts));
    least = std::min({least, least_eigenvalue(product(from, to)), least_eigenvalue(product(to, to))});
    from = to;
  }
  const double greatest = std::max(1.0, greatest_eigenvalue(product(from, from)));
  return {std::sqrt(least) * (1 - 0x1p-50), std::sqrt(greatest) * (1 + 0x1p-48)};
}

GradientFit fit_gradient(const Step& step, const BoxFrame& frame, std::span<const Index> vertices) {
  const Sampled sampled(step, frame, vertices);
  const DisplacementGradient gradient = sampled.least_squares();
  return {gradient, sampled.middle, sampled.way, sampled.mean_square_beside({}), sampled.mean_square_beside(gradient)};
}

}  // namespace tamis
