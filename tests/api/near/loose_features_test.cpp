// Rods and particles: compares contacts of loose points with loose edges and with each other, by every method and
// question, with the oracle. Contacts of faces and edges cover all other pairs of closed features.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "scenes/random.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/yardstick/methods.hpp"
#include "support/yardstick/pairs.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Random, scenes::Scene;

/// Rods, particles and a triangle on a coarse lattice, so that many of them meet exactly.
Scene rods_and_particles(Index rods, Index particles, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto vertex = [&] {
    const auto point = [&] {
      return Point{std::floor(random.between(0, 5)), std::floor(random.between(0, 5)),
                   std::floor(random.between(0, 3))};
    };
    return scene.add_vertex(point(), point(), 0);
  };
  for (Index i = 0; i < rods; ++i) {
    const Index a = vertex();
    scene.loose_edges.push_back({a, vertex()});
  }
  for (Index i = 0; i < particles; ++i) scene.loose_points.push_back(vertex());
  const Index a = vertex(), b = vertex();
  scene.faces.push_back({a, b, vertex()});
  return scene;
}

PairSet truth_of(const Scene& scene, double separation) {
  PairSet truth;
  yardstick::for_each_pair(scene.mesh(), {}, [&](PairKind kind, const PairVertices& v) {
    const oracle::Motion motion = motion_of(scene, v);
    if (separation > 0 ? oracle::comes_within(kind, motion, separation) : oracle::touches(kind, motion))
      truth.insert({kind, v});
  });
  return truth;
}

// Bug: a face whose corners are one vertex keeps this from counting as a loose point, though the face has no edge: a
// rod goes through the vertex unseen, in steps that are all reported free.
TEST(LooseFeatures, AFaceThatIsOneVertexIsAPoint) {
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {9, 9, 9}},
      end{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}, {9, 9, 9}};
  for (const std::vector<Face>& faces :
       {std::vector<Face>{{2, 2, 2}}, {{2, 2, 2}, {2, 2, 2}}, {{2, 2, 3}, {2, 2, 2}}}) {
    Detector detector(Mesh(4, faces, {{0, 1}}));
    std::span<const Contact> contacts = detector.contacts({start, end});
    const auto is_met = [](const Contact& c) {
      return c.kind == PairKind::vertex_edge && c.vertices == std::array<Index, 4>{2, 0, 1, -1};
    };
    EXPECT_EQ(std::count_if(contacts.begin(), contacts.end(), is_met), 1);
    EXPECT_FALSE(detector.is_free({start, end}));
  }
}

// Bugs: a kind that a method does not look for, finds twice, or leaves out of a question; a tree of the wrong features.
TEST(LooseFeatures, MeetInEveryMethodAndQuestion) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = rods_and_particles(6, 25, seed);
    for (const double separation : {0.0, 0.25}) {
      const PairSet truth = truth_of(scene, separation);
      std::size_t ve = 0, vv = 0;
      for (const PairName& pair : truth) {
        ve += pair.kind == PairKind::vertex_edge;
        vv += pair.kind == PairKind::vertex_vertex;
      }
      EXPECT_GT(vv, 0u);
      EXPECT_GT(ve, 0u);
      for (const Method method : kMethods) {
        SCOPED_TRACE(std::string(name_of(method)) + ", seed " + std::to_string(seed) + ", " +
                     std::to_string(separation));
        yardstick::Options options;
        options.method = method;
        options.min_separation = separation;
        Detector detector = yardstick::make_detector(scene.mesh(), options);
        const std::vector<Contact> contacts = copied(detector.contacts(scene.step()));
        EXPECT_EQ(names_of(contacts).size(), contacts.size()) << "a pair twice";
        EXPECT_EQ(missing(truth, names_of(contacts)), "") << "missed";
        EXPECT_EQ(missing(names_of(contacts), truth), "") << "found, but farther apart";
        EXPECT_FALSE(detector.is_free(scene.step()));
      }
    }
  }
}

// Bug: loose features count for contacts, but not for step lengths or the first contact.
TEST(LooseFeatures, EndTheStepAsContactsDo) {
  Scene scene;
  scene.loose_edges.push_back({scene.add_vertex({-1, 0, 0}, {-1, 0, 0}, 0), scene.add_vertex({1, 0, 0}, {1, 0, 0}, 0)});
  scene.loose_points.push_back(scene.add_vertex({0, 0, 4}, {0, 0, -4}, 1));
  scene.loose_points.push_back(scene.add_vertex({9, 0, 4}, {9, 0, 4}, 1));
  for (const Method method : kMethods) {
    SCOPED_TRACE(name_of(method));
    yardstick::Options options;
    options.method = method;
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    const EarliestContact first = detector.earliest(scene.step(), {.min_separation = 2.0});
    ASSERT_TRUE(first.contact.has_value());
    EXPECT_EQ(first.contact->kind, PairKind::vertex_edge);
    EXPECT_NEAR(first.toi_lower, 0.25, 1e-9);
    const SafeStep safe = detector.safe_step(scene.step(), 0.5);
    ASSERT_TRUE(safe.pair.has_value());
    EXPECT_EQ(safe.pair->vertices, (std::array<Index, 4>{2, 0, 1, -1}));
    EXPECT_NEAR(safe.toi_lower, 0.25, 1e-9);
  }
}

}  // namespace
}  // namespace tamis::test
