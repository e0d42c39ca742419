// How much is a path asked?
#pragma once
#include "tamis/path.hpp"

namespace tamis::test {

/// Another path, which counts how often it is asked for positions.
class CountedPath final : public Path {
 public:
  explicit CountedPath(const Path& path) : path_(path) {}
  Index vertex_count() const override { return path_.vertex_count(); }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    ++asked;
    path_.points_at(time, vertices, points, errors);
  }
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override {
    ++asked;
    ++asked_finely;
    path_.fine_points_at(time, vertices, points);
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    path_.deviations(from, to, vertices, deviations);
  }
  void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const override {
    path_.straight_directions(vertices, directions);
  }
  mutable int asked = 0, asked_finely = 0;

 private:
  const Path& path_;
};

}  // namespace tamis::test
