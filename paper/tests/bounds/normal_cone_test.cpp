// Normal cones must contain every normal of every triangle at every time, through all merges.
#include "paper/bounds/normal_cone.hpp"

#include <gtest/gtest.h>

#include <random>

#include "search/bounds/random_point.hpp"

namespace tamis::lab {
namespace {

using Triangle = std::array<Moving<double>, 3>;

/// Near the xy-plane, moving by up to `motion`.
Triangle random_triangle(std::mt19937_64& random, double motion) {
  Triangle t{{{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 1, 0}}}};
  for (auto& p : t) {
    p.at0 = p.at0 + random_point(random, 0.3);
    p.at1 = p.at0 + random_point(random, motion);
  }
  return t;
}

NormalCone around(const Triangle& t) { return NormalCone::around(t[0], t[1], t[2]); }

void expect_inside(const NormalCone& cone, const Triangle& t) {
  if (cone.half_angle >= 3) return;
  for (int i = 0; i <= 20; ++i) {
    const double time = i / 20.0;
    const auto n = cross(at_time(t[1], time) - at_time(t[0], time), at_time(t[2], time) - at_time(t[0], time));
    EXPECT_LE(std::acos(dot(n, cone.axis) / std::sqrt(dot(n, n))), cone.half_angle);
  }
}

TEST(normal_cone, contains_the_normals_at_all_times_through_merges) {
  std::mt19937_64 random(1);
  int narrow = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Triangle> triangles(8);
    for (Triangle& t : triangles) t = random_triangle(random, 0.01 * (round % 30));
    NormalCone all = around(triangles[0]);
    for (std::size_t i = 1; i < triangles.size(); ++i) all = merge(all, around(triangles[i]));
    for (const Triangle& t : triangles) expect_inside(all, t);
    narrow += all.half_angle < 1.5 ? 1 : 0;
  }
  EXPECT_GT(narrow, 100);
}

TEST(normal_cone, a_triangle_that_turns_over_or_has_no_area_gives_no_cone) {
  Triangle t{{{{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, -1, 0}}}};
  EXPECT_GT(around(t).half_angle, 3);
  t[2] = t[1];
  EXPECT_GT(around(t).half_angle, 3);
}

}  // namespace
}  // namespace tamis::lab
