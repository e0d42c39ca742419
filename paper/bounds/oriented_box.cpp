#include "paper/bounds/oriented_box.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/assert.hpp"
#include "paper/bounds/principal_axes.hpp"

namespace tamis::lab {
namespace {

using Vec = Vec3<double>;

/// The box of `points` with the axes of their covariance. Each point may be off by `slack` in every component.
OrientedBox fit(std::span<const Vec> points, double padding, double slack) {
  Vec mean{0, 0, 0};
  for (const Vec& p : points) mean = mean + p;
  mean = (1.0 / static_cast<double>(points.size())) * mean;
  SymmetricMatrix covariance;
  for (const Vec& p : points) covariance.add_square(p - mean);
  OrientedBox box{{0, 0, 0}, principal_axes(covariance), {}};
  double reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = dot(box.axes[i], points[0]), high = low;
    for (const Vec& p : points) {
      low = std::min(low, dot(box.axes[i], p));
      high = std::max(high, dot(box.axes[i], p));
    }
    reach += std::max(std::fabs(low), std::fabs(high));
    box.half[i] = 0.5 * (high - low) + padding + 2 * slack;
    box.centre = box.centre + 0.5 * (low + high) * box.axes[i];
  }
  // Covers the rounding of the projections and of their middle, and the error of the centre built along skew axes.
  for (double& half : box.half) half += 32 * OrientedBox::kSkew * (reach + half);
  return box;
}

std::array<Vec, 8> corners(const OrientedBox& box) {
  std::array<Vec, 8> result;
  for (unsigned k = 0; k < 8; ++k) {
    result[k] = box.centre;
    for (unsigned i = 0; i < 3; ++i) result[k] = result[k] + ((k >> i & 1) ? box.half[i] : -box.half[i]) * box.axes[i];
  }
  return result;
}

/// Largest |axis.(p - centre)| over the box, rounded up; allows for the skew of the box' axes.
double radius_along(const OrientedBox& box, const Vec& axis, double axis_size) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += box.half[i] * std::fabs(dot(axis, box.axes[i]));
  return sum + 16 * OrientedBox::kSkew * axis_size * box.extent();
}

bool separates(const OrientedBox& a, const OrientedBox& b, const Vec& axis) {
  const double size = std::fabs(axis.x) + std::fabs(axis.y) + std::fabs(axis.z);
  const Vec apart = b.centre - a.centre;
  const double reach = radius_along(a, axis, size) + radius_along(b, axis, size);
  const double rounding = 0x1p-48 * size * (std::fabs(apart.x) + std::fabs(apart.y) + std::fabs(apart.z));
  return std::fabs(dot(axis, apart)) > reach * (1 + 0x1p-48) + rounding + 0x1p-500;
}

}  // namespace

OrientedBox OrientedBox::around(std::span<const Moving<double>> points, const Vec& origin, double padding) {
  TAMIS_ASSERT(!points.empty() && points.size() <= 3);
  std::array<Vec, 6> ends;
  std::size_t count = 0;
  for (const Moving<double>& p : points) {
    ends[count++] = p.at0 - origin;
    ends[count++] = p.at1 - origin;
  }
  return fit(std::span(ends).first(count), padding, 0x1p-51);
}

OrientedBox merge(const OrientedBox& a, const OrientedBox& b) {
  const auto of_a = corners(a), of_b = corners(b);
  std::array<Vec, 16> points;
  std::copy(of_a.begin(), of_a.end(), points.begin());
  std::copy(of_b.begin(), of_b.end(), points.begin() + 8);
  // A corner computed from skew axes may miss the true one by 8 skews of the extent.
  return fit(points, 0, 16 * OrientedBox::kSkew * (a.extent() + b.extent()));
}

bool overlap(const OrientedBox& a, const OrientedBox& b) {
  for (const auto* box : {&a, &b})
    for (const Vec& axis : box->axes)
      if (separates(a, b, axis)) return false;
  for (const Vec& of_a : a.axes)
    for (const Vec& of_b : b.axes)
      if (separates(a, b, cross(of_a, of_b))) return false;
  return true;
}

}  // namespace tamis::lab
