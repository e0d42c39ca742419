// Curves in the plane: the same calls decide edges and points with z = 0 exactly, though every pair of them is coplanar
// at all times.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/random.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/yardstick/methods.hpp"
#include "support/yardstick/pairs.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Random, scenes::Scene;

/// Polylines whose vertices go from a lattice point part of the way to another, and loose points among them.
Scene curves(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto vertex = [&] {
    const auto point = [&] { return Point{std::floor(random.between(0, 9)), std::floor(random.between(0, 9)), 0}; };
    const Point start = point();
    Point end = point();
    for (std::size_t k = 0; k < 2; ++k) end[k] = start[k] + (end[k] - start[k]) / 4;
    return scene.add_vertex(start, end, 0);
  };
  for (int curve = 0; curve < 3; ++curve) {
    Index last = vertex();
    for (int i = 0; i < 4; ++i) {
      const Index next = vertex();
      scene.loose_edges.push_back({last, next});
      last = next;
    }
  }
  for (int i = 0; i < 6; ++i) scene.loose_points.push_back(vertex());
  return scene;
}

// Bug: a pair that is coplanar at all times is considered free, or is not certified.
TEST(CurvesInThePlane, MeetExactlyWhereTheOracleSaysSo) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = curves(seed);
    PairSet truth;
    yardstick::for_each_pair(scene.mesh(), {}, [&](PairKind kind, const PairVertices& v) {
      if (oracle::touches(kind, motion_of(scene, v))) truth.insert({kind, v});
    });
    EXPECT_FALSE(truth.empty());
    for (const Method method : kMethods) {
      yardstick::Options options;
      options.method = method;
      Detector detector = yardstick::make_detector(scene.mesh(), options);
      const std::vector<Contact> contacts = copied(detector.contacts(scene.step()));
      EXPECT_EQ(certified_names_of(contacts), truth) << name_of(method) << ", seed " << seed;
      EXPECT_EQ(contacts.size(), truth.size());
    }
  }
}

// Bug: the contact gets the plane's normal, along which a pair within the plane cannot be parted.
TEST(CurvesInThePlane, ArePartedByNormalsThatLieInIt) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    for (const double separation : {0.0, 0.25}) {
      const Scene scene = curves(seed);
      yardstick::Options options;
      options.min_separation = separation;
      for (const Contact& c : find_contacts(scene, options)) {
        if (c.toi_lower == 0) continue;  // edges may cross each other there
        EXPECT_EQ(c.normal[2], 0);
        EXPECT_NEAR(std::hypot(c.normal[0], c.normal[1]), 1, 1e-12);
        ++count;
      }
    }
  EXPECT_GT(count, 50u);
}

// Bug: distances fail for pairs that lie in one plane.
TEST(CurvesInThePlane, HaveDistancesAndStepLengths) {
  Scene scene;
  scene.loose_edges.push_back({scene.add_vertex({0, 0, 0}, {0, 0, 0}, 0), scene.add_vertex({4, 0, 0}, {4, 0, 0}, 0)});
  scene.loose_edges.push_back({scene.add_vertex({1, 3, 0}, {1, -1, 0}, 1), scene.add_vertex({2, 5, 0}, {2, 1, 0}, 1)});
  Detector detector(scene.mesh());
  const auto& near = detector.pairs_within(scene.start, 3);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].distance, 3);
  EXPECT_EQ(near[0].u, 0.25);
  EXPECT_EQ(weights_of(near[0].kind, near[0].u, near[0].v), (std::array<double, 4>{0.75, 0.25, -1, 0}));
  EXPECT_EQ(near[0].direction, (Point{0, -1, 0}));
  EXPECT_NEAR(detector.safe_step(scene.step(), 0.5).toi_lower, 0.375, 1e-9);
  EXPECT_NEAR(detector.earliest(scene.step(), {.min_separation = 1.0}).toi_lower, 0.5, 1e-9);
}

}  // namespace
}  // namespace tamis::test
