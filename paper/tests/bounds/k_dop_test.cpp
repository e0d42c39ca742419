// Swept k-DOPs must contain what they bound, whatever float rounding does to them.
#include "paper/bounds/k_dop.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tamis::lab {
namespace {

using Wide = Vec3<long double>;

Wide widen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// The catch is a projection that cancels: x - y of two large, nearly equal coordinates.
Vec3<double> nasty_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 0), twin(0, 2);
  const auto coordinate = [&] { return std::ldexp(unit(random), exponent(random)); };
  Vec3<double> p{coordinate(), coordinate(), coordinate()};
  if (twin(random) == 0) p.y = std::nextafter(p.x, 1.0);
  if (twin(random) == 0) p.z = -p.y;
  return p;
}

template <std::size_t axes>
void expect_inside(const KDop<axes>& box, const Vec3<double>& point, const Vec3<double>& origin, double padding) {
  const Wide p = widen(point) - widen(origin);
  for_each_axis<axes>([&](auto i) {
    const long double s = project<i()>(p),
                      blow_up = static_cast<long double>(padding) * axis_length(i()) * (1 - 1e-15L);
    ASSERT_LE(static_cast<long double>(box.lower[i()]), s - blow_up) << "axis " << i();
    ASSERT_GE(static_cast<long double>(box.upper[i()]), s + blow_up) << "axis " << i();
  });
}

TEST(k_dop, contains_both_ends_of_the_motion_and_the_padding) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const Moving<double> point{nasty_point(random), nasty_point(random)};
    const Vec3<double> origin = nasty_point(random);
    const double padding = i % 3 ? 0 : std::ldexp(1.0, -i % 40);
    const auto box = Dop26::around(point, origin, padding);
    expect_inside(box, point.at0, origin, padding);
    expect_inside(box, point.at1, origin, padding);
  }
}

TEST(k_dop, merging_keeps_what_either_contains) {
  const Moving<double> p{{0, 0, 0}, {0.5, 0, 0}}, q{{0, -0.5, 0}, {0, 0.25, 0.75}};
  const Vec3<double> origin{0, 0, 0};
  const auto box = merge(Dop18::around(p, origin, 0), Dop18::around(q, origin, 0));
  for (const Vec3<double>& v : {p.at0, p.at1, q.at0, q.at1}) expect_inside(box, v, origin, 0);
}

TEST(k_dop, touching_features_overlap_and_distant_ones_do_not) {
  // Exactly touching boxes are common in symmetric scenes: a strict comparison the wrong way round loses them.
  const Vec3<double> origin{0.3, 0.3, 0.3};
  const Moving<double> left{{0, 0, 0}, {0.5, 0, 0}}, right{{0.5, 0, 0}, {0.75, 0, 0}}, far{{0.51, 0, 0}, {0.75, 0, 0}};
  EXPECT_TRUE(overlap(Dop16::around(left, origin, 0), Dop16::around(right, origin, 0)));
  EXPECT_FALSE(overlap(Dop16::around(left, origin, 0), Dop16::around(far, origin, 0)));
  EXPECT_TRUE(overlap(Dop16::around(left, origin, 0.005), Dop16::around(far, origin, 0.005)));
}

TEST(k_dop, diagonal_axes_tell_apart_what_boxes_cannot) {
  const Vec3<double> origin{0, 0, 0};
  const Moving<double> below{{-0.5, -0.4, 0}, {0.4, 0.5, 0}}, above{{-0.5, -0.6, 0}, {0.6, 0.5, 0}};
  EXPECT_TRUE(overlap(Aabb::around(below, origin, 0), Aabb::around(above, origin, 0)));
  const Moving<double> p{{0.1, 0.2, 0}, {0.7, 0.8, 0}}, q{{0.2, 0.1, 0}, {0.8, 0.7, 0}};  // x - y is -0.1 and +0.1
  EXPECT_TRUE(overlap(Aabb::around(p, origin, 0), Aabb::around(q, origin, 0)));
  EXPECT_FALSE(overlap(Dop16::around(p, origin, 0), Dop16::around(q, origin, 0)));
}

}  // namespace
}  // namespace tamis::lab
