#include "curves/motions/rounded_rotation.hpp"

#include <cmath>

#include "curves/motions/rotation.hpp"
#include "numbers/assert.hpp"
#include "numbers/error_bounds.hpp"

namespace tamis {
namespace {

using CosineSinc = rotation::CosineSinc<double>;

/// cos x and sin x / x from x^2 in [0, 1], by their series: within 4.9 u and 2.3 u.
CosineSinc of_small_angle(double square) {
  constexpr int kTerms = 10;  // 20! > 2^61
  CosineSinc result{1, 1};
  for (int k = kTerms - 1; k >= 0; --k) {
    result.cosine = 1 - square * (1 / ((2.0 * k + 1) * (2.0 * k + 2))) * result.cosine;
    result.sinc = 1 - square * (1 / ((2.0 * k + 2) * (2.0 * k + 3))) * result.sinc;
  }
  return result;
}

/// Cosine and sine of twice the angle, within 15.7 u and 8.1 u. 1 - 2 sin^2 x loses less than 2 cos^2 x - 1.
CosineSinc of_angle_from_half(double square_of_half) {
  const auto [cosine, sinc] = of_small_angle(square_of_half);
  return {1 - 2 * (square_of_half * sinc * sinc), sinc * cosine};
}

}  // namespace

RoundedRotation rounded_rotation(const Point& rotation, double off) {
  const auto [x, y, z] = rotation;
  const double square = x * x + y * y + z * z;
  TAMIS_ASSERT(square <= kLargestRoundedAngle * kLargestRoundedAngle * kRoundedUp);
  if (x == 0 && y == 0 && z == 0 && off == 0) return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0};
  const bool is_small = square <= 4;
  const CosineSinc half = is_small ? of_small_angle(square / 4) : of_angle_from_half(square / 16);
  const auto [a, b, c] = rotation::rows_of<double>({x, y, z}, half);
  const double angle = std::sqrt(square);
  const double lost = is_small ? 1 + 11 * angle + 1.5 * square : 5 + 25 * angle + 4.5 * square;
  return {{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}, (0x1p-53 * lost + off) * kRoundedUp};
}

}  // namespace tamis
