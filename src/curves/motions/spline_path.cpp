#include "tamis/spline_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "curves/motions/curvature.hpp"
#include "curves/motions/fine_point.hpp"
#include "numbers/error_bounds.hpp"
#include "numbers/finite.hpp"
#include "numbers/floating_point_state.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"

namespace tamis {

/// values[i] is the weight of frame first + i.
struct SplinePath::Weights {
  std::size_t first;
  std::vector<FineInterval> values;
};

namespace {

using Frames = std::vector<std::vector<Point>>;

FineInterval fine(double x) { return FineInterval(DoubleDouble(x)); }

/// A bound of |sum of weights times points|.
double length_above(std::initializer_list<std::pair<double, const Point*>> terms) {
  const auto along = [&](std::size_t axis) {
    Interval sum(0);
    for (const auto& [weight, point] : terms) sum = sum + Interval(weight) * Interval((*point)[axis]);
    return sum;
  };
  return tamis::length_above({along(0), along(1), along(2)});
}

/// The piece that holds a time, and how far the time lies beyond the piece's first frame. The latter is exact, in
/// pieces.
struct PieceTime {
  std::size_t piece;
  FineInterval beyond;
};

PieceTime piece_at(double time, std::size_t last) {
  const DoubleDouble place = DoubleDouble::product_of(time, static_cast<double>(last));
  double whole = std::floor(place.high);
  if (whole == place.high && place.low < 0) whole -= 1;
  whole = std::clamp(whole, 0.0, static_cast<double>(last - 1));
  return {static_cast<std::size_t>(whole), FineInterval(place) - fine(whole)};
}

}  // namespace

SplinePath::SplinePath(std::vector<std::vector<Point>> frames, std::size_t least) : frames_(std::move(frames)) {
  if (frames_.size() < least)
    throw InvalidPath("the path has " + std::to_string(frames_.size()) + " frames of points: give at least " +
                      std::to_string(least));
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (frames_[i].size() != frames_[0].size())
      throw InvalidPath("frame " + std::to_string(i) + " of the path has " + std::to_string(frames_[i].size()) +
                        " points, the first one " + std::to_string(frames_[0].size()) + ": give one a vertex");
    for (std::size_t v = 0; v < frames_[i].size(); ++v)
      if (!is_finite(frames_[i][v]))
        throw InvalidPath("vertex " + std::to_string(v) + " in frame " + std::to_string(i) +
                          " of the path is not finite: give finite positions");
  }
}

/// 0 for a path that was moved from: it has no frames.
Index SplinePath::vertex_count() const { return frames_.empty() ? 0 : static_cast<Index>(frames_[0].size()); }

void SplinePath::points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                           std::span<double> errors) const {
  const ComputingState state;
  const Weights weights = weights_at(time);
  std::vector<RoundedNumber> rounded;
  double error = 0;
  for (const FineInterval& w : weights.values) {
    rounded.push_back(rounded_number(w));
    error = std::max(error, rounded.back().error);
  }
  // Each product rounds once, and each of as many sums. That makes (n + 1) u of the sum of absolute values. 2 (n + 1) u
  // covers this bound's own rounding as well.
  const double each = static_cast<double>(rounded.size() + 1) * 0x1p-52;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto v = at(vertices[i]);
    Point x{0, 0, 0};
    double size = 0, weighted = 0;
    for (std::size_t k = 0; k < rounded.size(); ++k) {
      const Point& p = frames_[weights.first + k][v];
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += rounded[k].value * p[axis];
      const double largest = std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
      size += largest;
      weighted += std::fabs(rounded[k].value) * largest;
    }
    points[i] = x;
    errors[i] = (each * weighted + error * size) * kRoundedUp + 0x1p-1000;
  }
}

void SplinePath::fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const {
  const ComputingState state;
  const Weights weights = weights_at(time);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto v = at(vertices[i]);
    auto x = enclosed<DoubleDouble>({0, 0, 0});
    for (std::size_t k = 0; k < weights.values.size(); ++k)
      x = x + weights.values[k] * enclosed<DoubleDouble>(frames_[weights.first + k][v]);
    points[i] = fine_point(x);
  }
}

void SplinePath::deviations(double from, double to, std::span<const Index> vertices,
                            std::span<double> deviations) const {
  const ComputingState state;
  const Interval factor = chord_factor(Interval(to) - Interval(from));
  // x' has no jumps. So the largest |x''| of all pieces touched bounds the deviation.
  const std::size_t first = piece_at(from, acceleration_.size()).piece, last = piece_at(to, acceleration_.size()).piece;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    double largest = 0;
    for (std::size_t piece = first; piece <= last; ++piece)
      largest = std::max(largest, acceleration_[piece][at(vertices[i])]);
    deviations[i] = Curvature{largest}.deviation(factor);
  }
}

BezierPath::BezierPath(std::vector<std::vector<Point>> control_points) : SplinePath(std::move(control_points), 1) {
  const ComputingState state;
  const Frames& p = frames();
  const double degree = static_cast<double>(p.size() - 1);
  std::vector<double> acceleration;
  for (std::size_t v = 0; v < p[0].size(); ++v) {
    // x'' is the Bezier curve of n (n - 1) times the second differences of the control points.
    double largest = 0;
    for (std::size_t i = 0; i + 2 < p.size(); ++i)
      largest = std::max(largest, length_above({{1, &p[i][v]}, {-2, &p[i + 1][v]}, {1, &p[i + 2][v]}}));
    acceleration.push_back((Interval(degree * (degree - 1)) * Interval(largest)).upper);
  }
  add_piece(std::move(acceleration));
}

/// De Casteljau: the weights of degree n from the weights of degree n - 1.
SplinePath::Weights BezierPath::weights_at(double time) const {
  const FineInterval t = fine(time), s = fine(1) - t;
  Weights weights{0, {fine(1)}};
  auto& w = weights.values;
  while (w.size() < frames().size()) {
    w.push_back(w.back() * t);
    for (std::size_t i = w.size() - 2; i > 0; --i) w[i] = s * w[i] + t * w[i - 1];
    w[0] = s * w[0];
  }
  return weights;
}

CatmullRomPath::CatmullRomPath(std::vector<std::vector<Point>> all) : SplinePath(std::move(all), 2) {
  const ComputingState state;
  const Frames& p = frames();
  const std::size_t last = p.size() - 1;
  const double pieces = static_cast<double>(last);
  for (std::size_t i = 0; i < last; ++i) {
    std::vector<double> acceleration;
    // Between frames b and c, with the slopes m and n there, the Bezier points are b, b + m/3, c - n/3, c. So x'' goes
    // linearly from 6 (c - b) - 4 m - 2 n at b to -6 (c - b) + 2 m + 4 n at c.
    const std::size_t a = i > 0 ? i - 1 : 0, d = std::min(i + 2, last);
    const double m = i > 0 ? 0.5 : 1, n = i + 2 <= last ? 0.5 : 1;
    for (std::size_t v = 0; v < p[0].size(); ++v) {
      const Point *at_a = &p[a][v], *at_b = &p[i][v], *at_c = &p[i + 1][v], *at_d = &p[d][v];
      const double start =
          length_above({{6, at_c}, {-6, at_b}, {-4 * m, at_c}, {4 * m, at_a}, {-2 * n, at_d}, {2 * n, at_b}});
      const double end =
          length_above({{-6, at_c}, {6, at_b}, {2 * m, at_c}, {-2 * m, at_a}, {4 * n, at_d}, {-4 * n, at_b}});
      acceleration.push_back((Interval(std::max(start, end)) * Interval(pieces) * Interval(pieces)).upper);
    }
    add_piece(std::move(acceleration));
  }
}

/// Hermite's weights, the slopes written as differences of frames.
SplinePath::Weights CatmullRomPath::weights_at(double time) const {
  const std::size_t last = frames().size() - 1;
  const auto [piece, u] = piece_at(time, last);
  const FineInterval one = fine(1), s = one - u;
  Weights weights{piece > 0 ? piece - 1 : 0, {}};
  weights.values.assign(std::min(piece + 2, last) - weights.first + 1, fine(0));
  const auto add = [&](std::size_t frame, const FineInterval& w) {
    FineInterval& sum = weights.values[frame - weights.first];
    sum = sum + w;
  };
  const auto add_slope = [&](std::size_t frame, const FineInterval& w) {
    const std::size_t before = frame > 0 ? frame - 1 : 0, after = std::min(frame + 1, last);
    const FineInterval part = fine(1.0 / static_cast<double>(after - before)) * w;  // 1 or 1/2
    add(after, part);
    add(before, -part);
  };
  add(piece, (one + fine(2) * u) * s * s);
  add(piece + 1, u * u * (fine(3) - fine(2) * u));
  add_slope(piece, u * s * s);
  add_slope(piece + 1, -(u * u * s));
  return weights;
}

}  // namespace tamis
