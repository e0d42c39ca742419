// Enclosures of rotations, and the deviations and errors of rigid paths, against longer arithmetic and the motion
// itself.
#include "curves/motions/rotation.hpp"

#include <gtest/gtest.h>

#include "curves/motions/fine_point.hpp"
#include "curves/motions/rigid_transform.hpp"
#include "curves/motions/rounded_rotation.hpp"
#include "curves/paths/turning_pairs.hpp"
#include "oracle/exact_numbers.hpp"

namespace tamis::test {
namespace {

using oracle::Integer, oracle::Rational;

/// cos x and sin x / x by their series, to some 250 bits, from the square of x.
std::pair<Rational, Rational> by_series(double angle) {
  const Integer one = Integer(1) << 1536;  // the terms of an angle of 400 reach e^400
  const Rational exact_square = Rational(angle) * Rational(angle);
  const Integer square = numerator(exact_square) * one / denominator(exact_square);
  Integer cosine = 0, sinc = 0, term = one;
  for (int k = 0; k < 700; ++k) {
    cosine += term;
    const Integer odd = term / (2 * k + 1);
    sinc += odd;
    term = -(odd * square) / one / (2 * k + 2);
  }
  return {Rational(cosine, one), Rational(sinc, one)};
}

Rational exact(double x) { return Rational(x); }
Rational exact(const DoubleDouble& x) { return exact(x.high) + exact(x.low); }

void expect_enclosed(double angle) {
  const auto [cosine, sinc] = by_series(angle);
  const FineInterval x(angle);
  const auto enclosed = rotation::any_angle(x * x);
  for (const auto& [interval, value] : {std::pair{enclosed.cosine, cosine}, std::pair{enclosed.sinc, sinc}}) {
    EXPECT_LE(exact(interval.lower), value) << angle;
    EXPECT_GE(exact(interval.upper), value) << angle;
    EXPECT_LE(upper_double(interval.upper - interval.lower), 1e-28 * (1 + angle * angle)) << angle;
  }
}

// Bug: a term of the series forgotten; a doubling too few; rounding inward.
TEST(Rotation, EnclosesCosineAndSine) {
  Random random(5);
  for (int i = 0; i < 200; ++i) expect_enclosed(std::pow(10.0, random.between(-8, 2.6)));
  expect_enclosed(0);
}

/// The largest error of an entry, by that which is said.
double share_of_error(const Point& rotation, double off) {
  const RoundedRotation rounded = rounded_rotation(rotation, off);
  const rotation::Rows truth = rotation::matrix(enclosed<DoubleDouble>(rotation));
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<FineInterval>& row = truth[i];
      const FineInterval& entry = k == 0 ? row.x : k == 1 ? row.y : row.z;
      most = std::max(most, farthest_from(DoubleDouble(rounded.rows[i][k]), entry) / rounded.error);
    }
  return most;
}

// Bug: an error that is too small, for an angle of any size, on either side of that from which cosines are doubled.
TEST(Rotation, InDoublesIsOffByNoMoreThanItSays) {
  Random random(7);
  double most = 0;
  for (int i = 0; i < 50000; ++i) {
    const double angle = i % 3 == 0   ? random.between(1.99, 2.01)
                         : i % 3 == 1 ? random.between(0, 4)
                                      : std::pow(10.0, random.between(-9, 0.6));
    Point rotation = random.point_between(-1, 1);
    if (i % 5 == 0) rotation[static_cast<std::size_t>(i / 5 % 3)] = 0;
    const double length = std::hypot(rotation[0], rotation[1], rotation[2]);
    for (double& x : rotation) x *= angle / length;
    most = std::max(most, share_of_error(rotation, 0));
  }
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.1) << "the bound is not sharp";
}

// Bug: what turns about an axis of coordinates leaves its plane.
TEST(Rotation, AboutAnAxisOfCoordinatesKeepsThatCoordinate) {
  for (const double angle : {1e-200, 0.3, 3.0}) {
    const RoundedRotation rounded = rounded_rotation({0, angle, 0}, 0);
    EXPECT_EQ(rounded.rows[1], (Point{0, 1, 0}));
    EXPECT_EQ(rounded.rows[0][1], 0);
    EXPECT_EQ(rounded.rows[2][1], 0);
  }
  EXPECT_EQ(rounded_rotation({0, 0, 0}, 0).error, 0);
}

Turning any_turning(Random& random, double angle) {
  return {random.point_between(-angle, angle), random.point_between(-angle, angle), random.point_between(-3, 3),
          random.point_between(-3, 3)};
}

double distance_of(const oracle::RealPoint& a, const oracle::RealPoint& b) {
  return static_cast<double>(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
}

oracle::RealPoint between(const oracle::RealPoint& a, const oracle::RealPoint& b, oracle::Real s) {
  return {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])};
}

// Bug: positions off by more than they say; a bound on a deviation that is too small, for a piece of any length. Every
// other vertex goes straight in its body's frame.
TEST(RigidPath, KeepsItsPromises) {
  Random random(6);
  constexpr std::array<Index, 1> kVertex{0};
  double tightest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Turning body = any_turning(random, std::pow(10.0, random.between(-3, 1.5)));
    const Point x = random.point_between(-2, 2), x_end = i % 2 == 0 ? x : random.point_between(-2, 2);
    const RigidPath path({x}, {0}, {interpolated_chain({body.p0, body.theta0}, {body.p1, body.theta1})}, {x_end});
    const auto position = [&](oracle::Real t) {
      return between(oracle::position(body, x, t), oracle::position(body, x_end, t), t);
    };
    const double from = random.unit(), to = from + (1 - from) * std::pow(10.0, random.between(-6, 0));
    std::array<double, 1> deviation{}, error{};
    std::array<Point, 1> point{};
    path.deviations(from, to, kVertex, deviation);
    const auto a = position(from), b = position(to);
    for (int k = 0; k <= 8; ++k) {
      const oracle::Real s = k / oracle::Real(8), t = from + s * (oracle::Real(to) - from);
      const double off = distance_of(position(t), between(a, b, s));
      EXPECT_LE(off, deviation[0] + 1e-16);
      tightest = std::max(tightest, off / (deviation[0] + 1e-300));
    }
    path.points_at(from, kVertex, point, error);
    EXPECT_LE(distance_of(a, {point[0][0], point[0][1], point[0][2]}), 1.8 * error[0] + 1e-17);
    std::array<FinePoint, 1> fine;
    path.fine_points_at(from, kVertex, fine);
    EXPECT_LT(fine[0].error, 1e-24);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fine[0].high[k], point[0][k], error[0]);
  }
  EXPECT_GT(tightest, 0.9) << "the bound of the deviation is not sharp";
}

// Bug: chains composed the wrong way round; the turned pose not reached.
TEST(RigidPath, ChainsAndTurnsEndWhereTheyShould) {
  Random random(8);
  constexpr std::array<Index, 1> kVertex{0};
  const auto place = [&](const RigidChain& chain, const Point& x, double t) {
    std::array<FinePoint, 1> fine;
    RigidPath({x}, {0}, {chain}).fine_points_at(t, kVertex, fine);
    return oracle::RealPoint{fine[0].high[0], fine[0].high[1], fine[0].high[2]};
  };
  for (int i = 0; i < 200; ++i) {
    const Turning a = any_turning(random, 2), b = any_turning(random, 2);
    const Point x = random.point_between(-2, 2);
    const Pose a0{a.p0, a.theta0}, a1{a.p1, a.theta1};
    const RigidChain moved = chain_between(a0, a1);
    EXPECT_LT(distance_of(place(moved, x, 0), oracle::position(a, x, 0)), 1e-14);
    EXPECT_LT(distance_of(place(moved, x, 1), oracle::position(a, x, 1)), 1e-13);
    // first b, then a
    const double t = random.unit();
    const auto inner = oracle::position(b, x, t);
    const Point y{static_cast<double>(inner[0]), static_cast<double>(inner[1]), static_cast<double>(inner[2])};
    const RigidChain chain{{a0, a1}, {{b.p0, b.theta0}, {b.p1, b.theta1}}};
    EXPECT_LT(distance_of(place(chain, x, t), oracle::position(a, y, t)), 1e-14);
  }
}

}  // namespace
}  // namespace tamis::test
