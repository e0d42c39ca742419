// Pairs listed ahead, where lists are hard to make or to leave: features that deviate, a way beyond all doubles, a
// curve, one place where all is near all.
#include <gtest/gtest.h>

#include <string>

#include "scenes/random.hpp"
#include "scenes/scene_list.hpp"
#include "support/as_new.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

// Bugs: room for one of two features that deviate towards each other; room in another unit than the motion.
TEST(TwoFacesOnTheirWay, AreFoundWhenBothDeviate) {
  const std::vector<Face> faces{{0, 1, 2}, {3, 4, 5}};
  for (const double edge : {1.0, 0x1p-6, 0x1p6}) {
    const double way = edge / 64;
    bool was_listed_once = false;
    for (double deviation = 0x1p-16 * edge; deviation < 0.1 * edge; deviation *= 1.4) {
      const auto place = [&](double x, double off) {
        const double low = off, high = 1.9 * deviation - off;
        return std::vector<Point>{{x, 0, low},
                                  {x + edge, 0, low},
                                  {x, edge, low},
                                  {x + 0.25 * edge, 0.25 * edge, high},
                                  {x + edge, 0.25 * edge, high + edge},
                                  {x, 1.25 * edge, high + edge}};
      };
      Detector kept(Mesh(6, faces));
      for (int i = 0; i < 3; ++i) {
        const std::vector<Point> start = place(i * way, 0), end = place((i + 1) * way, 0);
        EXPECT_TRUE(kept.contacts({start, end}).empty());
      }
      const std::vector<Point> start = place(3 * way, 0), end = place(4 * way, deviation);
      EXPECT_FALSE(kept.contacts({start, end}).empty()) << edge << ' ' << deviation;
      was_listed_once |= was_listed(kept);
    }
    EXPECT_TRUE(was_listed_once) << edge;
  }
}

// Bug: a room that is infinite where edges are so long that their sum is, and then holds whatever is not a number. A
// third face stands still, as large as doubles allow, and jumps.
TEST(TwoFacesOnTheirWay, AreFoundBesideAFaceThatLeavesAllDoubles) {
  const auto place = [](double x, double high, double jump) {
    return std::vector<Point>{{x, 0, 0},
                              {x + 1, 0, 0},
                              {x, 1, 0},
                              {x + 0.25, 0.25, high},
                              {x + 1, 0.25, 1},
                              {x, 1.25, 1},
                              {jump, -5e307, 5e307},
                              {5e307, 5e307, 5e307},
                              {-5e307, 5e307, 5e307}};
  };
  Detector kept(Mesh(9, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}));
  for (int i = 0; i < 4; ++i) {
    const std::vector<Point> start = place(i / 64.0, 0.1, -5e307),
                             end = place((i + 1) / 64.0, i < 3 ? 0.1 : -0.1, i < 3 ? -5e307 : 1.7e308);
    expect_as_new(kept, {start, end}, Asked::contacts, std::to_string(i));
    EXPECT_EQ(kept.contacts({start, end}).empty(), i < 3);
  }
}

// Bug: lists for a way ahead that leaves all doubles, at a vertex that is not in the sample.
TEST(FacesOnTheirWay, AreFoundWhenItLeadsBeyondAllDoubles) {
  scenes::Random random(7);
  const Index faces = 401;
  Mesh mesh = [&] {
    std::vector<Face> all;
    for (Index f = 0; f < faces; ++f) all.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    return Mesh(3 * faces, all);
  }();
  std::vector<Point> shape;
  for (Index v = 0; v < 3 * faces; ++v) shape.push_back(random.point_between(-1, 1));
  const auto place = [&](int i) {
    std::vector<Point> points = shape;
    for (Point& point : points) point[0] += i / 64.0 * (1 + point[1] * point[2]);
    points[1][0] = 8e307 + 2e307 * i;
    return points;
  };
  Detector kept(std::move(mesh));
  for (int i = 0; i < 4; ++i) {
    const std::vector<Point> start = place(i), end = place(i + 1);
    expect_as_new(kept, {start, end}, Asked::contacts, std::to_string(i));
  }
}

// Bug: pieces of a curve, which deviate from their chords, taken for what was listed.
TEST(TwoFacesOnTheirWay, AreFoundWhenTheyLeaveItOnACurve) {
  const auto place = [&](double x, double bulge) {
    return std::vector<Point>{{x, 0, bulge},  {x + 1, 0, bulge},  {x, 1, bulge},
                              {x, 0.25, 0.1}, {x + 1, 0.25, 1.1}, {x, 1.25, 1.1}};
  };
  const std::vector<Face> faces{{0, 1, 2}, {3, 4, 5}};
  Detector kept(Mesh(6, faces));
  for (int i = 0; i < 3; ++i) {
    const std::vector<Point> start = place(i, 0), end = place(i + 1, 0);
    EXPECT_TRUE(kept.contacts({start, end}).empty());
  }
  ASSERT_TRUE(was_listed(kept));
  EXPECT_FALSE(kept.contacts(BezierPath({place(3, 0), place(3.5, 0.3), place(4, 0)})).empty());
}

// Bug: lists without bounds; or, once they are given up, boxes of the way ahead.
TEST(PairsAheadInALayer, AreGivenUpWhereAllIsNearAll) {
  const Scene scene = scenes::scene_by_name("soup", 1000, 3);
  scenes::Random random(5);
  std::vector<Point> shape(scene.start.size());
  for (Point& point : shape) point = {random.between(-1, 1), random.between(-1, 1), random.between(-1e-6, 1e-6)};
  const auto moved = [&](double t) {
    std::vector<Point> points = shape;
    for (Point& point : points) point[0] += t * (1 + 0.01 * point[1]);
    return points;
  };
  Options one_thread;  // another one brings buffers of its own
  one_thread.threads = 1;
  Detector kept(scene.mesh(), one_thread);
  for (int i = 0; i < 6; ++i) {
    const std::vector<Point> start = moved(i / 16.0), end = moved((i + 1) / 16.0);
    const std::uint64_t before = kept.statistics().memory_bytes;
    expect_as_new(kept, {start, end}, Asked::is_free, std::to_string(i));
    EXPECT_FALSE(was_listed(kept)) << i;
    if (i > 0) {
      EXPECT_LT(kept.statistics().memory_bytes, before + (1 << 20)) << i;
    }
  }
}

}  // namespace
}  // namespace tamis::test
