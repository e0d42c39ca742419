// A path that Python describes: two callables.
#pragma once
#include "python/src/arrays.hpp"
#include "tamis/path.hpp"

namespace tamis::python {

/// `points_at(time, vertices)` gives points (n, 3) and errors (n,), `deviations(from, to, vertices)` bounds (n,); the
/// Python side has made sure that they do. Asked from several threads, one at a time.
class FunctionPath final : public Path {
 public:
  FunctionPath(Index vertex_count, nb::object points_at, nb::object deviations)
      : vertex_count_(vertex_count), points_at_(std::move(points_at)), deviations_(std::move(deviations)) {}

  Index vertex_count() const override { return vertex_count_; }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override;
  void deviations(double from, double to, std::span<const Index> vertices, std::span<double> deviations) const override;

 private:
  Index vertex_count_;
  nb::object points_at_;
  nb::object deviations_;
};

}  // namespace tamis::python
