// The unit of length changes nothing: the same motion at scales that are powers of two has the same times, bit for bit.
// Bug: an error that is a number, of a rotation, added to one that is a length: at small scales bodies far apart cannot
// be told from each other.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "curves/paths/turning_pairs.hpp"
#include "scenes/shapes.hpp"
#include "support/as_new.hpp"
#include "tamis/detector.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {
namespace {

constexpr int kExponents[] = {-500, -333, -100, -53, -50, -49, -30, -1, 1, 30, 50, 100, 333, 500};

std::vector<Point> scaled(std::vector<Point> points, double scale) {
  for (Point& p : points)
    for (double& x : p) x *= scale;
  return points;
}

RigidChain scaled(RigidChain chain, double scale) {
  for (RigidLink& link : chain)
    for (Pose* pose : {&link.start, &link.end})
      for (double& x : pose->position) x *= scale;
  return chain;
}

/// Two balls: one turns, the other passes.
class TwoBalls {
 public:
  TwoBalls() {
    add(scenes::unit_sphere(2), {1, 0.6, 0.8}, 0);
    add(scenes::unit_sphere(1), {0.5, 0.7, 1}, 1);
  }
  Mesh mesh() const { return {static_cast<Index>(rest_.size()), faces_}; }
  Options options() const {
    Options options;
    options.filter = PairFilter::no_self_contact(body_);
    return options;
  }
  RigidPath turning(double distance, double scale) const {
    const RigidChain first = turned_chain({{0, 0, 0}, {0.1, 0.2, 0.3}}, {0, 0, 0.5}, {0, 0, 0}),
                     second = turned_chain({{distance, 0, 0}, {0, 0.3, 0}}, {0.2, -0.5, 0.1}, {distance - 0.1, 0.5, 0});
    return {scaled(rest_, scale), body_, {scaled(first, scale), scaled(second, scale)}};
  }
  /// By control points, or through frames.
  template <class Spline>
  Spline along(double distance, double scale) const {
    std::vector<std::vector<Point>> frames(3, rest_);
    for (std::size_t v = 0; v < rest_.size(); ++v)
      for (std::size_t i = 0; i < 3 && body_[v] == 1; ++i) {
        const double t = 0.5 * static_cast<double>(i);
        frames[i][v][0] += distance - 0.1 * t;
        frames[i][v][1] += 0.3 * t * t;
      }
    for (auto& frame : frames) frame = scaled(frame, scale);
    return Spline(frames);
  }

 private:
  void add(const scenes::Shape& shape, const Point& size, Index body) {
    const auto first = static_cast<Index>(rest_.size());
    for (const Point& p : shape.points) {
      rest_.push_back({size[0] * p[0], size[1] * p[1], size[2] * p[2]});
      body_.push_back(body);
    }
    for (const Face& f : shape.faces) faces_.push_back({first + f[0], first + f[1], first + f[2]});
  }

  std::vector<Point> rest_;
  std::vector<Face> faces_;
  std::vector<Index> body_;
};

/// `make_path(scale)`: contacts within a separation at each scale, and that there are some, or none.
template <class MakePath>
void expect_same_at_all_scales(const TwoBalls& balls, const MakePath& make_path, double separation, bool is_free) {
  Detector detector(balls.mesh(), balls.options());
  const auto expected = bits_of(detector.contacts(make_path(1.0), {.min_separation = separation}));
  EXPECT_EQ(expected.empty(), is_free) << separation;
  for (const int exponent : kExponents) {
    const double scale = std::ldexp(1.0, exponent);
    const auto path = make_path(scale);
    EXPECT_EQ(bits_of(detector.contacts(path, {.min_separation = separation * scale})), expected)
        << separation << " times 2^" << exponent;
    EXPECT_EQ(detector.is_free(path, {.min_separation = separation * scale}), is_free)
        << separation << " times 2^" << exponent;
  }
}

TEST(UnitOfLength, DoesNotMatterToTurningBodies) {
  const TwoBalls balls;
  const auto at = [&](double distance) { return [=, &balls](double scale) { return balls.turning(distance, scale); }; };
  for (const double separation : {0.0, 0.05}) expect_same_at_all_scales(balls, at(1.1), separation, false);
  expect_same_at_all_scales(balls, at(1.5), 0.001, true);  // a hundred separations apart
}

TEST(UnitOfLength, DoesNotMatterToSplines) {
  const TwoBalls balls;
  for (const double separation : {0.0, 0.05}) {
    expect_same_at_all_scales(
        balls, [&](double scale) { return balls.along<BezierPath>(1.35, scale); }, separation, false);
    expect_same_at_all_scales(
        balls, [&](double scale) { return balls.along<CatmullRomPath>(1.35, scale); }, separation, false);
    expect_same_at_all_scales(
        balls, [&](double scale) { return balls.along<BezierPath>(1.7, scale); }, separation, true);
  }
}

/// A point that comes down on a turning triangle, to a height of its own, in units of 2^exponent.
PairResult lowered_to(double height, int exponent, double separation) {
  const double scale = std::ldexp(1.0, exponent);
  const std::vector<Point> rest{{0.1, 0.2, 0}, {-3, -3, 0}, {3, -3, 0}, {0, 3, 0}};
  const RigidChain down = turned_chain({{0, 0, 1}, {0, 0, 0}}, {0, 0, 0.7}, {0, 0, height}),
                   turn = turned_chain({}, {0, 0, 1}, {});
  const RigidPath path(scaled(rest, scale), {0, 1, 1, 1}, {scaled(down, scale), scaled(turn, scale)});
  return vertex_face(path, {0, 1, 2, 3}, {separation * scale});
}

TEST(UnitOfLength, DoesNotMatterToWhatIsAsNearAsItsSeparation) {
  constexpr double kSeparation = 0.01;
  for (int exponent = -500; exponent <= 500; exponent += 25)
    for (const double gap : {-1e-2, -1e-10, 1e-9, 1e-4, 1.0, 50.0}) {
      const PairResult one = lowered_to(kSeparation * (1 + gap), 0, kSeparation);
      const PairResult same = lowered_to(kSeparation * (1 + gap), exponent, kSeparation);
      EXPECT_EQ(same.touches, gap < 0) << gap << " of the separation, times 2^" << exponent;
      EXPECT_EQ(same.toi_lower, one.toi_lower) << gap << " of the separation, times 2^" << exponent;
      EXPECT_EQ(same.toi_upper, one.toi_upper) << gap << " of the separation, times 2^" << exponent;
      EXPECT_EQ(same.certainty, one.certainty) << gap << " of the separation, times 2^" << exponent;
    }
}

}  // namespace
}  // namespace tamis::test
