// Poses from what engines keep.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tamis/error.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {
namespace {

using Rows = std::array<Point, 3>;

/// Where the pose takes the axes, by the path's own arithmetic.
Rows rows_of(const Pose& pose) {
  const RigidPath path({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, {interpolated_chain({{}, pose.rotation}, pose)});
  const std::array<Index, 3> all{0, 1, 2};
  std::array<Point, 3> columns{};
  std::array<double, 3> errors{};
  path.points_at(0, all, columns, errors);
  Rows rows{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) rows[i][j] = columns[j][i];
  return rows;
}

std::array<double, 4> random_quaternion(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) {
    x = normal(random);
    square += x * x;
  }
  for (double& x : q) x /= std::sqrt(square);
  return q;
}

void expect_near(const Rows& a, const Rows& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(a[i][j], b[i][j], tolerance);
}

TEST(Pose, OfAQuaternionAndItsMatrixIsTheSame) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto q = random_quaternion(random);
    const auto [w, x, y, z] = q;
    const Rows rows{{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                     {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                     {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
    expect_near(rows_of(pose_of_quaternion(q, {})), rows, 1e-14);
    expect_near(rows_of(pose_of_matrix(rows, {})), rows, 1e-14);
    Rows floats = rows;
    for (Point& row : floats)
      for (double& entry : row) entry = static_cast<float>(entry);
    expect_near(rows_of(pose_of_matrix(floats, {})), rows, 2e-7);
  }
}

TEST(Pose, OfHalfTurnsIsKnown) {
  const double pi = std::numbers::pi;
  expect_near(rows_of(pose_of_matrix(Rows{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {})),
              {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, 1e-15);
  EXPECT_NEAR(std::fabs(pose_of_quaternion({0, 0, 0, 1}, {}).rotation[2]), pi, 1e-15);
  EXPECT_EQ(pose_of_quaternion({-1, 0, 0, 0}, {1, 2, 3}).rotation, (Point{0, 0, 0}));
  EXPECT_EQ(pose_of_quaternion({-1, 0, 0, 0}, {1, 2, 3}).position, (Point{1, 2, 3}));
}

/// Where the chain takes the axes at a time, by the path's own arithmetic.
Rows axes_at(const RigidChain& chain, double time) {
  const RigidPath path({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, {chain});
  const std::array<Index, 3> all{0, 1, 2};
  Rows points{};
  std::array<double, 3> errors{};
  path.points_at(time, all, points, errors);
  return points;
}

TEST(Pose, OnAChainIsWhereThePathHasTheBody) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> number(-2, 2);
  const auto point = [&] { return Point{number(random), number(random), number(random)}; };
  for (int i = 0; i < 200; ++i) {
    const Pose start{point(), point()}, end{point(), point()};
    for (const RigidChain& chain :
         {interpolated_chain(start, end), chain_between(start, end, point()), turned_chain(start, point(), point()),
          RigidChain{{start, end}, {end, start}, {start, start}}, RigidChain{}})
      for (const double time : {0.0, 0.3, 1.0}) {
        const Pose there = pose_at(chain, time);
        expect_near(axes_at(interpolated_chain(there, there), 0), axes_at(chain, time), 2e-14);
      }
    EXPECT_EQ(pose_at(interpolated_chain(start, end), 0).rotation, start.rotation);
    EXPECT_EQ(pose_at(interpolated_chain(start, end), 1).position, end.position);
  }
}

TEST(Pose, OnAChainOutsideOfTheStepIsRefused) {
  for (const double time : {-0.1, 1.1, std::nan("")}) EXPECT_THROW((void)pose_at({}, time), InvalidPath);
  EXPECT_THROW((void)pose_at(interpolated_chain({{std::nan(""), 0, 0}, {}}, {}), 0), InvalidPath);
  try {
    (void)pose_at({}, 2);
    FAIL();
  } catch (const InvalidPath& e) {
    EXPECT_STREQ(e.what(), "time is 2: give a number in [0,1]");
  }
}

TEST(Pose, OfNoRotationIsRefused) {
  EXPECT_NO_THROW((void)pose_of_quaternion({1.00004, 0, 0, 0}, {}));
  EXPECT_THROW((void)pose_of_quaternion({1.0001, 0, 0, 0}, {}), InvalidPath);
  EXPECT_THROW((void)pose_of_quaternion({0, 0, 0, 0}, {}), InvalidPath);
  EXPECT_THROW((void)pose_of_quaternion({std::nan(""), 0, 0, 0}, {}), InvalidPath);
  EXPECT_THROW((void)pose_of_matrix(Rows{{{1.0001, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}), InvalidPath);
  EXPECT_THROW((void)pose_of_matrix(Rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}}}, {}), InvalidPath);
  try {
    (void)pose_of_matrix(Rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, {});
    FAIL();
  } catch (const InvalidPath& e) {
    EXPECT_STREQ(e.what(), "the matrix is a reflection: give a rotation, which rounding may have changed by 1e-4");
  }
}

}  // namespace
}  // namespace tamis::test
