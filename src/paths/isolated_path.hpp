// A caller's path, asked in the middle of a question.
#pragma once
#include "query/isolated.hpp"
#include "tamis/path.hpp"

namespace tamis {

class IsolatedPath : public Path {
 public:
  /// Keeps a reference.
  explicit IsolatedPath(const Path& path) : path_(path) {}

  Index vertex_count() const override { return path_.vertex_count(); }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    isolated([&] { path_.points_at(time, vertices, points, errors); });
  }
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override {
    isolated([&] { path_.fine_points_at(time, vertices, points); });
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    isolated([&] { path_.deviations(from, to, vertices, deviations); });
  }
  void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const override {
    isolated([&] { path_.straight_directions(vertices, directions); });
  }

 private:
  const Path& path_;
};

}  // namespace tamis
