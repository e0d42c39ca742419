// Would catch: positions of another time or vertex, a time that is computed again and again.
#include "curves/paths/cached_path.hpp"

#include <gtest/gtest.h>

namespace tamis {
namespace {

/// Vertex v is at (v, t, 0); counts how often many vertices were asked for at once.
class CountingPath final : public Path {
 public:
  Index vertex_count() const override { return 100; }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    calls += 1;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      points[i] = {static_cast<double>(vertices[i]), time, 0};
      errors[i] = time * vertices[i];
    }
  }
  void deviations(double, double, std::span<const Index>, std::span<double>) const override {}
  mutable int calls = 0;
};

void expect_right(const Path& path, double time, const std::vector<Index>& vertices) {
  std::vector<Point> points(vertices.size());
  std::vector<double> errors(vertices.size());
  path.points_at(time, vertices, points, errors);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    EXPECT_EQ(points[i], (Point{static_cast<double>(vertices[i]), time, 0}));
    EXPECT_EQ(errors[i], time * vertices[i]);
  }
}

TEST(CachedPath, SaysWhatThePathSaysAtAnyTimeOfAnyVertex) {
  const CountingPath path;
  const std::vector<Index> used{3, 8, 20, 99};
  const CachedPath remembered(path, used);
  for (int round = 0; round < 3; ++round)
    for (int i = 0; i <= 500; ++i) {
      expect_right(remembered, i / 500.0, {99, 3});
      expect_right(remembered, i / 500.0, {20, 8, 7});  // 7 is not a used one
    }
}

TEST(CachedPath, AsksForATimeTwiceAndThenNoMore) {
  const CountingPath path;
  const std::vector<Index> used{1, 2, 3, 4};
  const CachedPath remembered(path, used);
  for (int i = 0; i < 1000; ++i)
    for (const double time : {0.0, 1.0}) expect_right(remembered, time, {2, 4});
  EXPECT_EQ(path.calls, 4);
}

}  // namespace
}  // namespace tamis
