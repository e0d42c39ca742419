// Ready-made paths of vertices that move on polynomials: Bezier curves, and frames joined by Catmull-Rom splines.
#pragma once
#include <utility>
#include <vector>

#include "tamis/path.hpp"

namespace tamis {

/// The common base of BezierPath and CatmullRomPath. x(t) is a sum of given points with weights that depend on the time
/// alone. [0,1] has pieces of equal length. On each piece |x''| has a bound.
class SplinePath : public Path {
 public:
  /// Returns the number of vertices.
  Index vertex_count() const override;
  /// Write as Path: positions, the same more precisely, and deviations.
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override;
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override;
  void deviations(double from, double to, std::span<const Index> vertices, std::span<double> deviations) const override;

 protected:
  struct Weights;

  /// Takes the given points. `frames[i][v]`: point i of vertex v.
  /// Throws InvalidPath on fewer than `least` frames, frames of different sizes, and numbers that are not finite.
  SplinePath(std::vector<std::vector<Point>> frames, std::size_t least);

  /// Returns the given points.
  const std::vector<std::vector<Point>>& frames() const { return frames_; }
  /// Adds the next piece: for each vertex a bound of |x''| on it.
  void add_piece(std::vector<double> acceleration) { acceleration_.push_back(std::move(acceleration)); }

 private:
  /// Returns the weights of the given points at `time`.
  virtual Weights weights_at(double time) const = 0;

  std::vector<std::vector<Point>> frames_;
  std::vector<std::vector<double>> acceleration_;  ///< [piece][vertex]
};

/// Each vertex on a Bezier curve: every polynomial motion can be written so.
class BezierPath final : public SplinePath {
 public:
  /// Takes control points. `control_points[i][v]`: the i-th control point of vertex v. Their number is the degree plus
  /// one, at least 1.
  /// Throws InvalidPath as the constructor of SplinePath.
  explicit BezierPath(std::vector<std::vector<Point>> control_points);

 private:
  Weights weights_at(double time) const override;
};

/// Goes smoothly through frames at equal distances of time. Between two frames it is a cubic, with the slope (next -
/// previous) / 2 at each frame. At the first and the last frame it is the slope of the chord (Catmull, Rom 1974).
class CatmullRomPath final : public SplinePath {
 public:
  /// Takes frames. `frames[i][v]`: where vertex v is at t = i / (frames - 1); at least 2 frames.
  /// Throws InvalidPath as the constructor of SplinePath.
  explicit CatmullRomPath(std::vector<std::vector<Point>> frames);

 private:
  Weights weights_at(double time) const override;
};

}  // namespace tamis
