// A caller's path, whose functions run in the caller's floating-point state.
#pragma once
#include "numbers/floating_point_state.hpp"
#include "tamis/path.hpp"

namespace tamis {

class CallersPath final : public Path {
 public:
  /// Keeps a reference.
  explicit CallersPath(const Path& path) : path_(path) {}

  Index vertex_count() const override {
    const CallersState state;
    return path_.vertex_count();
  }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    const CallersState state;
    path_.points_at(time, vertices, points, errors);
  }
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override {
    const CallersState state;
    path_.fine_points_at(time, vertices, points);
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    const CallersState state;
    path_.deviations(from, to, vertices, deviations);
  }
  void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const override {
    const CallersState state;
    path_.straight_directions(vertices, directions);
  }
  std::optional<CarriedPath> carried(std::span<const Index> vertices) const override {
    const CallersState state;
    return path_.carried(vertices);
  }

 private:
  const Path& path_;
};

}  // namespace tamis
