// Every bounding volume of the paper's hierarchy: what is inside stays inside through any number of merges, and two
// volumes with a common point overlap. Each test runs for each volume.
#include "paper/bounds/swept_volume.hpp"

#include <gtest/gtest.h>

#include <random>

#include "paper/bounds/oriented_box.hpp"
#include "paper/bounds/sphere.hpp"
#include "search/bounds/random_point.hpp"

namespace tamis::lab {
namespace {

template <class Volume>
class SweptVolume : public testing::Test {};
using Volumes = testing::Types<Sphere, OrientedBox, Aabb, Dop16, Dop18, Dop26>;
TYPED_TEST_SUITE(SweptVolume, Volumes);

const Vec3<double> kOrigin{0.25, -0.125, 0.3};

using Triangle = std::array<Moving<double>, 3>;

/// Flat, thin and point-like ones too.
Triangle random_triangle(std::mt19937_64& random) {
  const double size = std::ldexp(1.0, -std::uniform_int_distribution<int>(2, 30)(random));
  const Vec3<double> place = random_point(random, 0.5);
  Triangle t;
  for (auto& p : t) p = {place + random_point(random, size), place + random_point(random, size)};
  if (random() % 3 == 0) t[2] = t[1];
  if (random() % 4 == 0) t[1] = t[0] = {t[0].at0, t[0].at0};
  return t;
}

/// A point that the moving triangle passes: a corner's at some time, or a midpoint.
Vec3<double> some_point(const Triangle& t, std::mt19937_64& random) {
  const Vec3<double> a = t[random() % 3].at0, b = t[random() % 3].at1;
  return random() % 2 ? a : 0.5 * (a + b);
}

template <class Volume>
Volume around(const Triangle& t, double padding = 0) {
  return volume_around<Volume>(t, kOrigin, padding);
}

template <class Volume>
Volume around(const Vec3<double>& point) {
  const Moving<double> still{point, point};
  return volume_around<Volume>(std::span(&still, 1), kOrigin, 0);
}

TYPED_TEST(SweptVolume, overlaps_every_point_it_bounds_after_many_merges) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Triangle> triangles(16);
    for (Triangle& t : triangles) t = random_triangle(random);
    TypeParam all = around<TypeParam>(triangles[0]);
    for (std::size_t i = 1; i < triangles.size(); ++i) all = merge(all, around<TypeParam>(triangles[i]));
    for (const Triangle& t : triangles)
      for (int k = 0; k < 8; ++k) EXPECT_TRUE(overlap(all, around<TypeParam>(some_point(t, random))));
  }
}

TYPED_TEST(SweptVolume, overlaps_whatever_shares_a_point_with_it) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 2000; ++round) {
    const Triangle t = random_triangle(random);
    Triangle other = random_triangle(random);
    other[random() % 3].at1 = t[random() % 3].at0;
    EXPECT_TRUE(overlap(around<TypeParam>(t), around<TypeParam>(other)));
    EXPECT_TRUE(overlap(around<TypeParam>(other), around<TypeParam>(t)));
  }
}

TYPED_TEST(SweptVolume, padding_reaches_across_the_distance_and_no_padding_does_not) {
  const Vec3<double> gap{0.3, 0.4, 0};
  const Triangle t{{{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}};
  const Triangle other{{{gap, gap}, {gap, gap}, {gap, gap}}};
  EXPECT_FALSE(overlap(around<TypeParam>(t), around<TypeParam>(other)));
  EXPECT_FALSE(overlap(around<TypeParam>(t, 0.1), around<TypeParam>(other, 0.1)));
  EXPECT_TRUE(overlap(around<TypeParam>(t, 0.25), around<TypeParam>(other, 0.25)));
}

TYPED_TEST(SweptVolume, extent_is_finite_and_grows_when_merged) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 500; ++round) {
    const TypeParam a = around<TypeParam>(random_triangle(random)), b = around<TypeParam>(random_triangle(random));
    EXPECT_TRUE(std::isfinite(merge(a, b).extent()));
    EXPECT_GT(a.extent(), 0);
  }
}

}  // namespace
}  // namespace tamis::lab
