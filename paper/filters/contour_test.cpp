#include "paper/filters/contour_test.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/assert.hpp"

namespace tamis::lab {
namespace {

using Projected = std::array<double, 2>;

Projected operator-(const Projected& a, const Projected& b) { return {a[0] - b[0], a[1] - b[1]}; }
Moving2 operator-(const Moving2& a, const Moving2& b) { return {a.at0 - b.at0, a.at1 - b.at1}; }

double cross(const Projected& a, const Projected& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(const Projected& a, const Projected& b) { return a[0] * b[0] + a[1] * b[1]; }

/// Bernstein coefficients, without binomials, of a product of two moving vectors.
template <class Product>
std::array<double, 3> coefficients(const Moving2& a, const Moving2& b, const Product& product) {
  return {product(a.at0, b.at0), product(a.at0, b.at1) + product(a.at1, b.at0), product(a.at1, b.at1)};
}

std::array<double, 3> cross(const Moving2& a, const Moving2& b) {
  return coefficients(a, b, [](const Projected& x, const Projected& y) { return cross(x, y); });
}
std::array<double, 3> dot(const Moving2& a, const Moving2& b) {
  return coefficients(a, b, [](const Projected& x, const Projected& y) { return dot(x, y); });
}

bool all_above(const std::array<double, 3>& k, double error) { return k[0] > error && k[1] > error && k[2] > error; }
bool all_below(const std::array<double, 3>& k, double error) { return k[0] < error && k[1] < error && k[2] < error; }

/// Two vectors that span the plane orthogonal to the unit vector `n` and are right-handed with it.
std::array<Vec3<double>, 2> plane_of(const Vec3<double>& n) {
  const Vec3<double> helper = std::fabs(n.x) < 0.6 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
  const Vec3<double> p = cross(helper, n);
  return {p, cross(n, p)};
}

}  // namespace

void ProjectedContour::project(std::span<const Moving<double>> loop, const Vec3<double>& axis) {
  TAMIS_ASSERT(loop.size() >= 3);
  Moving<double> mean{{0, 0, 0}, {0, 0, 0}};
  for (const auto& p : loop) mean = mean + p;
  const double share = 1 / static_cast<double>(loop.size());
  mean = {share * mean.at0, share * mean.at1};
  const auto [p, q] = plane_of(axis);
  points_.clear();
  double size = 0;
  for (const auto& point : loop) {
    const Moving<double> v = point - mean;
    points_.push_back({{dot(p, v.at0), dot(q, v.at0)}, {dot(p, v.at1), dot(q, v.at1)}});
    size = std::max(size, largest(v));
  }
  // The errors are those of the exact projection along p x q; any moving point may be the centre. With u = 2^-53 and
  // components of p and q up to 1: a coordinate is off by 3 (1 + 1) u + 6 u = 12 u size and below 3 size; a difference
  // of two by 30 u size and below 6 size; a product of two differences by 2 * 6 * 30 u + 36 u = 396 u size^2; the four
  // products of a middle coefficient and their sums, each below 144 size^2, by 4 * 396 u + 3 * 144 u = 2016 u size^2.
  slack_ = 0x1p-53 * 64 * size + 0x1p-1000;
  error_ = 0x1p-53 * 4096 * size * size + 0x1p-1000;
}

bool ProjectedContour::proves_star_shaped() const {
  int turns = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Moving2 &a = points_[i], &b = points_[i + 1 < points_.size() ? i + 1 : 0];
    if (!all_above(cross(a, b), error_)) return false;
    // Every edge turns left around the centre, so the winding number is the number of edges that cross the positive
    // x axis upwards. This holds for the rounded points too, and their comparisons are exact.
    turns += a.at0[1] <= 0 && b.at0[1] > 0 ? 1 : 0;
  }
  return turns == 1;
}

bool ProjectedContour::proves_simple() const {
  const std::size_t n = points_.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!neighbours_stay_unfolded(i)) return false;
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) && !edges_stay_apart(i, j)) return false;
  return true;
}

bool ProjectedContour::neighbours_stay_unfolded(std::size_t edge) const {
  const std::size_t n = points_.size();
  const Moving2 a = points_[edge], b = points_[(edge + 1) % n], c = points_[(edge + 2) % n];
  const auto turn = cross(b - a, c - b);
  return all_above(turn, error_) || all_below(turn, -error_) || all_above(dot(b - a, c - b), error_);
}

bool ProjectedContour::edges_stay_apart(std::size_t i, std::size_t j) const {
  const std::size_t n = points_.size();
  const Moving2 a = points_[i], b = points_[(i + 1) % n], c = points_[j], d = points_[(j + 1) % n];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto low = [&](const Projected& x, const Projected& y) { return std::min(x[axis], y[axis]) - slack_; };
    const auto high = [&](const Projected& x, const Projected& y) { return std::max(x[axis], y[axis]) + slack_; };
    if (high(a.at0, b.at0) < low(c.at0, d.at0) && high(a.at1, b.at1) < low(c.at1, d.at1)) return true;
    if (high(c.at0, d.at0) < low(a.at0, b.at0) && high(c.at1, d.at1) < low(a.at1, b.at1)) return true;
  }
  const auto keeps_on_one_side = [&](const Moving2& p, const Moving2& q, const Moving2& r, const Moving2& s) {
    const auto of_r = cross(q - p, r - p), of_s = cross(q - p, s - p);
    return (all_above(of_r, error_) && all_above(of_s, error_)) ||
           (all_below(of_r, -error_) && all_below(of_s, -error_));
  };
  return keeps_on_one_side(a, b, c, d) || keeps_on_one_side(c, d, a, b);
}

}  // namespace tamis::lab
