// Splines against their definitions in long double.
#include "tamis/spline_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/random.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using Real = long double;
using RealPoint = std::array<Real, 3>;
using Frames = std::vector<std::vector<Point>>;
constexpr std::array<Index, 1> kVertex{0};

RealPoint mix(const RealPoint& a, const RealPoint& b, Real t) {
  RealPoint c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = (1 - t) * a[k] + t * b[k];
  return c;
}
RealPoint real(const Point& p) { return {p[0], p[1], p[2]}; }

RealPoint de_casteljau(std::vector<RealPoint> points, Real t) {
  for (; points.size() > 1; points.pop_back())
    for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = mix(points[i], points[i + 1], t);
  return points[0];
}

RealPoint bezier(const Frames& frames, Real t) {
  std::vector<RealPoint> points;
  for (const auto& frame : frames) points.push_back(real(frame[0]));
  return de_casteljau(points, t);
}

/// The cubic between two frames by its Bezier points.
RealPoint catmull_rom(const Frames& frames, Real t) {
  const std::size_t last = frames.size() - 1;
  const std::size_t i = std::min(static_cast<std::size_t>(t * static_cast<Real>(last)), last - 1);
  const auto slope = [&](std::size_t k) {
    const std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, last);
    RealPoint m{};
    for (std::size_t x = 0; x < 3; ++x)
      m[x] = (Real(frames[after][0][x]) - frames[before][0][x]) / static_cast<Real>(after - before);
    return m;
  };
  const RealPoint b = real(frames[i][0]), c = real(frames[i + 1][0]), m = slope(i), n = slope(i + 1);
  RealPoint second = b, third = c;
  for (std::size_t x = 0; x < 3; ++x) {
    second[x] += m[x] / 3;
    third[x] -= n[x] / 3;
  }
  return de_casteljau({b, second, third, c}, t * static_cast<Real>(last) - static_cast<Real>(i));
}

double distance(const RealPoint& a, const RealPoint& b) {
  return static_cast<double>(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
}

template <class PathType>
void expect_promises(RealPoint (*truth)(const Frames&, Real), std::size_t least, std::size_t most) {
  scenes::Random random(2);
  double tightest = 0;
  for (int i = 0; i < 1000; ++i) {
    Frames frames(least + static_cast<std::size_t>(random.below(static_cast<Index>(most - least + 1))));
    for (auto& frame : frames) frame = {random.point_between(-2, 2)};
    const PathType path(frames);
    const double from = random.unit(), to = from + (1 - from) * std::pow(10.0, random.between(-6, 0));
    const RealPoint a = truth(frames, from), b = truth(frames, to);
    std::array<double, 1> deviation{}, error{};
    std::array<Point, 1> point{};
    std::array<FinePoint, 1> fine;
    path.deviations(from, to, kVertex, deviation);
    for (int k = 1; k < 8; ++k) {
      const Real s = k / Real(8);
      const double off = distance(truth(frames, from + s * (Real(to) - from)), mix(a, b, s));
      EXPECT_LE(off, deviation[0] + 1e-16);
      if (deviation[0] > 1e-6) tightest = std::max(tightest, off / deviation[0]);
    }
    path.points_at(from, kVertex, point, error);
    path.fine_points_at(from, kVertex, fine);
    EXPECT_LE(distance(a, real(point[0])), 1.8 * error[0] + 1e-17);
    EXPECT_LT(error[0], 1e-13);
    EXPECT_LT(fine[0].error, 1e-27);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fine[0].high[k], static_cast<double>(a[k]), 1e-15);
  }
  EXPECT_GT(tightest, 0.8) << "the bound of the deviation is not sharp";
}

// Bug: weights of another frame; a second difference forgotten; the joint of two cubics.
TEST(SplinePath, BezierKeepsItsPromises) { expect_promises<BezierPath>(bezier, 1, 7); }
TEST(SplinePath, CatmullRomKeepsItsPromises) { expect_promises<CatmullRomPath>(catmull_rom, 2, 7); }

TEST(SplinePath, CatmullRomPassesThroughItsFrames) {
  scenes::Random random(3);
  Frames frames(6);
  for (auto& frame : frames) frame = {random.point_between(-2, 2)};
  const CatmullRomPath path(frames);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::array<FinePoint, 1> fine;
    path.fine_points_at(static_cast<double>(i) / 5, kVertex, fine);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(fine[0].high[k], frames[i][0][k], 1e-14) << i;
  }
}

TEST(SplinePath, BadFramesAreNamed) {
  EXPECT_THROW(BezierPath(Frames{}), InvalidPath);
  EXPECT_THROW(CatmullRomPath(Frames(1, {{0, 0, 0}})), InvalidPath);
  EXPECT_THROW(BezierPath(Frames{{{0, 0, 0}}, {}}), InvalidPath);
  EXPECT_THROW(BezierPath(Frames{{{0, std::nan(""), 0}}}), InvalidPath);
}

}  // namespace
}  // namespace tamis::test
