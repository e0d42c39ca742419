// Makes poses from the quaternions and matrices that engines keep, and chains of links from poses.
#include <algorithm>
#include <cmath>
#include <string>

#include "curves/motions/chain_motion.hpp"
#include "numbers/floating_point_state.hpp"
#include "numbers/length.hpp"
#include "numbers/number_text.hpp"
#include "search/topology/points.hpp"
#include "tamis/error.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis {
namespace {

/// The rotation vector of the unit quaternion (w, v); (-w, -v) has the same.
Point rotation_vector(double w, const Point& v) {
  const double sign = w < 0 ? -1 : 1, sine = length_of(v[0], v[1], v[2]);
  const double factor = sign * (sine > 0 ? 2 * std::atan2(sine, sign * w) / sine : 2);
  return {factor * v[0], factor * v[1], factor * v[2]};
}

constexpr double kMostRounding = 1e-4;
constexpr const char* kGiveRotation = ": give a rotation, which rounding may have changed by 1e-4";

using Rows = std::array<Point, 3>;

/// The largest difference of an entry of R R^T from the identity's. Or the first beyond kMostRounding, which may be
/// NaN.
double off_from_rotation(const Rows& rows) {
  double off = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = std::fabs(dot(rows[i], rows[j]) - (i == j));
      if (!(entry <= kMostRounding)) return entry;
      off = std::max(off, entry);
    }
  return off;
}

/// A step of Newton's method towards the nearest rotation: (3 R - R R^T R) / 2.
Rows nearer_rotation(const Rows& rows) {
  Rows next{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < 3; ++j) sum += dot(rows[i], rows[j]) * rows[j][k];
      next[i][k] = 1.5 * rows[i][k] - 0.5 * sum;
    }
  return next;
}

/// Where the pose takes x, rounded.
Point where(const Pose& pose, const Point& x) { return transform_at({{pose, pose}}, 0).of(x); }

/// The rotation vector of R1 R0^T, no longer than pi. Quaternions are well conditioned at every angle.
Point shorter_turn(const Pose& start, const Pose& end) {
  const auto quaternion = [](const Point& w) {
    const double angle = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    const double s = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
    return std::array{std::cos(angle / 2), s * w[0], s * w[1], s * w[2]};
  };
  const auto a = quaternion(start.rotation), b = quaternion(end.rotation);
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const Point axis{a[0] * b[1] - b[0] * a[1] + a[2] * b[3] - a[3] * b[2],
                   a[0] * b[2] - b[0] * a[2] + a[3] * b[1] - a[1] * b[3],
                   a[0] * b[3] - b[0] * a[3] + a[1] * b[2] - a[2] * b[1]};
  return rotation_vector(cosine, axis);
}

void require_finite(const Pose& start, const Pose& end) {
  if (!is_finite(start) || !is_finite(end))
    throw InvalidPath("a pose is not finite: give finite positions and rotation vectors");
}

}  // namespace

Pose pose_of_quaternion(const std::array<double, 4>& q, const Point& position) {
  const ComputingState state;
  const double off = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1;
  if (!(std::fabs(off) <= kMostRounding))
    throw InvalidPath("the square of the quaternion is off from 1 by " + number_text(off) + kGiveRotation);
  return {position, rotation_vector(q[0], {q[1], q[2], q[3]})};
}

/// The quaternion's largest component is found from the diagonal. The others come from sums and differences of the
/// entries beside it (Shepperd 1978).
Pose pose_of_matrix(const std::array<Point, 3>& given, const Point& position) {
  const ComputingState state;
  const double off = off_from_rotation(given);
  if (!(off <= kMostRounding))
    throw InvalidPath("an entry of R R^T - I of the matrix is " + number_text(off) + kGiveRotation);
  const Rows r = nearer_rotation(nearer_rotation(given));
  const double trace = r[0][0] + r[1][1] + r[2][2];
  const double determinant = dot(r[0], {r[1][1] * r[2][2] - r[1][2] * r[2][1], r[1][2] * r[2][0] - r[1][0] * r[2][2],
                                        r[1][0] * r[2][1] - r[1][1] * r[2][0]});
  if (!(determinant > 0)) throw InvalidPath(std::string("the matrix is a reflection") + kGiveRotation);
  std::array<double, 4> q{};
  if (trace >= r[0][0] && trace >= r[1][1] && trace >= r[2][2]) {
    q = {1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
  } else {
    const std::size_t i = r[0][0] >= r[1][1] && r[0][0] >= r[2][2] ? 0 : r[1][1] >= r[2][2] ? 1 : 2;
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    q[0] = r[k][j] - r[j][k];
    q[1 + i] = 1 + r[i][i] - r[j][j] - r[k][k];
    q[1 + j] = r[j][i] + r[i][j];
    q[1 + k] = r[k][i] + r[i][k];
  }
  return {position, rotation_vector(q[0], {q[1], q[2], q[3]})};
}

RigidChain interpolated_chain(const Pose& start, const Pose& end) { return {{start, end}}; }

RigidChain turned_chain(const Pose& start, const Point& turn, const Point& end_position, const Point& center) {
  const ComputingState state;
  const Point offset = where({{0, 0, 0}, start.rotation}, center);
  const Pose about_center{{0 - offset[0], 0 - offset[1], 0 - offset[2]}, start.rotation};
  return {{{where(start, center), {0, 0, 0}}, {end_position, turn}}, {about_center, about_center}};
}

RigidChain chain_between(const Pose& start, const Pose& end, const Point& center) {
  const ComputingState state;
  return turned_chain(start, shorter_turn(start, end), where(end, center), center);
}

Pose pose_at(const RigidChain& chain, double time) {
  const ComputingState state;
  if (!(0 <= time && time <= 1)) throw InvalidPath("time is " + number_text(time) + ": give a number in [0,1]");
  for (const RigidLink& link : chain) require_finite(link.start, link.end);
  if (chain.empty()) return {};
  if (const RigidLink& link = chain.front(); chain.size() == 1)
    return {rounded_linear(link.start.position, link.end.position, time).x,
            rounded_linear(link.start.rotation, link.end.rotation, time).x};
  const RoundedTransform there = transform_at(chain, time);
  return pose_of_matrix(there.rows, there.shift);
}

/// With H half the angle of the turn, the blend q goes straight from (1, 0) to (cos H, sin H). Its angle h has the rate
/// h' = sin H / |q|^2, so |h''| <= M = 4 sin H sin^2(H/2) / cos^4(H/2). h - t H is zero at 0, 1/2 and 1, so it is at
/// most M / 32. The turn differs by twice as much. The factor 1 + 2^-20 is far above all rounding.
double nlerp_deviation(const Pose& start, const Pose& end) {
  const ComputingState state;
  require_finite(start, end);
  const Point turn = shorter_turn(start, end);
  const double half = 0.5 * length_of(turn[0], turn[1], turn[2]);
  const double sine = std::sin(0.5 * half), square = std::pow(std::cos(0.5 * half), 2);
  return std::sin(half) * sine * sine / (4 * square * square) * (1 + 0x1p-20);
}

}  // namespace tamis
