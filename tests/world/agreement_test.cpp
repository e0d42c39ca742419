// A world says what a detector says of all its bodies as one mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "tamis/error.hpp"
#include "tamis/pair_distance.hpp"
#include "world/random_world.hpp"

namespace tamis::test {
namespace {

using ContactsByPair = std::map<NamedPair, Contact>;

bool turns(const TestWorld& world, BodyId id) {
  const auto* rigid = std::get_if<Rigid>(&world.bodies[place(id)].motion);
  return rigid && std::ranges::any_of(rigid->chain, [](const Link& l) { return l.start.rotation != l.end.rotation; });
}

/// Of the detector: on curves where one of the two bodies turns, else on the step.
ContactsByPair expected_contacts(const TestWorld& world, OneMesh& mesh, const QueryOptions& options = {}) {
  ContactsByPair expected;
  const auto add = [&](const std::vector<Contact>& contacts, bool of_curves) {
    for (const Contact& c : contacts) {
      const NamedPair name = named(c, mesh);
      const BodyId a = name.vertices[0][0], b = name.vertices[c.kind == PairKind::edge_edge ? 2 : 1][0];
      if ((turns(world, a) || turns(world, b)) == of_curves) expected.emplace(name, c);
    }
  };
  add(mesh.detector.contacts(mesh.step(), options), false);
  add(mesh.detector.contacts(mesh.path, options), true);
  return expected;
}

std::size_t expect_same_contacts(TestWorld& world, const QueryOptions& options = {}) {
  OneMesh mesh(world);
  const ContactsByPair expected = expected_contacts(world, mesh, options);
  const std::vector<BodyContact> found = world.world.contacts(options);
  EXPECT_EQ(found.size(), expected.size());
  auto each = expected.begin();
  for (const BodyContact& c : found) {
    if (each == expected.end()) break;
    const auto& [name, contact] = *each++;
    EXPECT_EQ(named(c), name);  // which says that they come in this order
    EXPECT_EQ(c.certainty, contact.certainty);
    EXPECT_NEAR(c.toi_lower, contact.toi_lower, 2e-9);
    EXPECT_NEAR(c.toi_upper, contact.toi_upper, 2e-9);
    if (turns(world, c.bodies[0]) || turns(world, c.bodies[1])) continue;
    EXPECT_NEAR(c.toi_lower, contact.toi_lower, 1e-14);
    EXPECT_NEAR(c.u, contact.u, 1e-10);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(c.normal[k], contact.normal[k], 1e-10);
  }
  return found.size();
}

void expect_same_first(TestWorld& world, const QueryOptions& options = {}) {
  double first = 1;
  for (const BodyContact& c : world.world.contacts(options)) first = std::min(first, c.toi_lower);
  const EarliestBodyContact earliest = world.world.earliest(options);
  EXPECT_NEAR(earliest.toi_lower, first, 2e-9);
  EXPECT_EQ(earliest.contact.has_value(), first < 1);
  EXPECT_EQ(world.world.is_free(options), !earliest.contact);
}

TEST(World, AgreesWithOneMeshThatGoesStraight) {
  std::size_t contacts = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 1.5, Motions::straight);
    contacts += expect_same_contacts(world);
    expect_same_first(world);
  }
  EXPECT_GT(contacts, 1000u);
}

TEST(World, AgreesWithOneMeshOnCurves) {
  std::size_t contacts = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 2, Motions::any);
    contacts += expect_same_contacts(world);
    expect_same_first(world);
  }
  EXPECT_GT(contacts, 1000u);
}

/// Far from the origin, with turns by up to fifty radians, and of bodies a thousand times as large as others.
TEST(World, AgreesWhereItIsHard) {
  const std::array<Extremes, 3> kinds{{{{1e7, -3e6, 2e7}, 1, 1}, {{}, 20, 1}, {{}, 1, 1e-3}}};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::size_t contacts = 0;
    for (std::uint64_t seed = 304; seed < 309; ++seed) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << seed);
      TestWorld world = random_world(seed, 2.5, seed % 2 ? Motions::any : Motions::straight, one_thread(), kinds[kind]);
      contacts += expect_same_contacts(world);
      expect_same_first(world);
    }
    EXPECT_GT(contacts, 50u);
  }
}

TEST(World, AgreesWithinASeparation) {
  for (std::uint64_t seed = 100; seed < 110; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 2.5, Motions::any);
    expect_same_contacts(world, {.min_separation = 0.02});
  }
}

/// The random worlds again, of bodies that are thick, some more than others.
TEST(World, AgreesWithRadii) {
  std::size_t contacts = 0, near = 0;
  for (std::uint64_t seed = 200; seed < 212; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 2.5, seed % 2 ? Motions::any : Motions::straight);
    expect_same_contacts(world);  // what is gathered here knows of no radii
    Random random(seed);
    for (BodyId id = 0; place(id) < world.bodies.size(); ++id) world.set_radius(id, 0.03 * random.below(3));
    contacts += expect_same_contacts(world, {.min_separation = 0.01});
    expect_same_first(world);
    OneMesh mesh(world);
    const std::vector<NearPair>& expected = mesh.detector.pairs_within(mesh.start, 0.02);
    const std::vector<BodyNearPair> found = world.world.pairs_within(0.02);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(named(found[i]), named(expected[i], mesh));
    near += found.size();
    if (seed % 2) continue;
    EXPECT_EQ(world.world.safe_step(0.3).lower, mesh.detector.safe_step(mesh.step(), 0.3).lower);
  }
  EXPECT_GT(contacts, 500u);
  EXPECT_GT(near, 200u);
}

/// What is kept from one question to the next changes nothing.
TEST(World, AgreesStepAfterStep) {
  TestWorld world = random_world(7, 1.5, Motions::any);
  Random random(8);
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE(step);
    expect_same_contacts(world);
    const BodyId body = random.below(static_cast<int>(world.bodies.size()));
    world.move(body, random_motion(random, world.bodies[place(body)].shape, 1.5, Motions::any));
  }
}

/// A sheet in waves that slides over still ground, askew: sides that cross in parallel have times that are less sharp.
struct SlidingSheet {
  static constexpr double kEdge = 0.1;

  static Shape sheet(Index cells) {
    scenes::Scene scene;
    scenes::add_grid_faces(scene, 0, cells + 1, cells + 1);
    std::vector<Point> points;
    for (Index i = 0; i <= cells; ++i)
      for (Index j = 0; j <= cells; ++j)
        points.push_back({kEdge * i, kEdge * j, 0.03 * kEdge * std::sin(7.0 * i + 11.0 * j)});
    return Shape(Mesh(static_cast<Index>(points.size()), scene.faces), points);
  }

  /// `speed`: edges a step.
  explicit SlidingSheet(double speed_, Options options = one_thread()) : speed(speed_), world(std::move(options)) {
    world.add(ground, Static{});
    body = world.add(cloth, motion(0));
  }
  std::vector<Point> cloth_at(int step) const {
    std::vector<Point> points = cloth.points();
    for (Point& p : points) {
      p = {0.92 * p[0] - 0.38 * p[1], 0.39 * p[0] + 0.91 * p[1], p[2]};
      p[0] += kEdge * std::min(3.37 + speed * step, 25.13);
      p[1] += 4.41 * kEdge;
      p[2] += kEdge * (0.05 + 0.2 * std::cos(0.9 * step));
    }
    return points;
  }
  Deforming motion(int step) const { return {cloth_at(step), cloth_at(step + 1)}; }

  const Shape ground = sheet(24), cloth = sheet(6);
  const double speed;
  TestWorld world;
  BodyId body;
};

/// Nor where a body goes on, and what was gathered serves until its room is used up: slowly, or faster than any room.
TEST(World, AgreesWhereASheetSlidesOverTheGround) {
  std::size_t contacts = 0;
  for (const double speed : {0.0413, 0.3071, 1.7137, 5.0719}) {
    SCOPED_TRACE(speed);
    SlidingSheet sliding(speed);
    TestWorld& world = sliding.world;
    for (int step = 0; step < 30; ++step) {
      SCOPED_TRACE(step);
      world.move(sliding.body, sliding.motion(step));
      contacts += expect_same_contacts(world, {.min_separation = step % 7 == 6 ? 0.05 * SlidingSheet::kEdge : 0});
      if (step % 5) continue;
      OneMesh mesh(world);
      EXPECT_EQ(world.world.safe_step(0.2).lower, mesh.detector.safe_step(mesh.step(), 0.2).lower);
    }
  }
  EXPECT_GT(contacts, 5000u);
}

/// Nor where questions are cancelled, wherever they ask whether they are: here also while more and more of a bowl is
/// tried as what might be gathered.
TEST(World, AgreesWhereQuestionsWereCancelled) {
  int looks_left = -1, cancelled = 0;
  Options options = one_thread();
  options.is_cancelled = [&] { return looks_left-- == 0; };
  TestWorld world(options);
  const Shape ground = SlidingSheet::sheet(24), flat = SlidingSheet::sheet(12);
  std::vector<Point> points = flat.points();
  for (Point& p : points) {
    p[2] += 0.5 * (std::pow(p[0] - 0.6, 2) + std::pow(p[1] - 0.6, 2));
    p = {0.92 * p[0] - 0.38 * p[1], 0.39 * p[0] + 0.91 * p[1], p[2]};
  }
  world.add(ground, Static{});
  const auto at = [](int step) { return Pose{{0.3 + 0.17 * step, 0.3, 0.004 * std::cos(0.9 * step) - 0.015}, {}}; };
  const BodyId bowl = world.add(
      Shape(Mesh(static_cast<Index>(points.size()), {flat.mesh().faces().begin(), flat.mesh().faces().end()}), points),
      Rigid{interpolated(at(0), at(1))});
  std::size_t contacts = 0;
  for (int step = 0; step < 10; ++step) {
    SCOPED_TRACE(step);
    world.move(bowl, Rigid{interpolated(at(step), at(step + 1))});
    for (int looks = 0; looks < 5; ++looks) {
      looks_left = looks;
      try {
        world.world.contacts();
      } catch (const Cancelled&) {
        ++cancelled;
      }
    }
    looks_left = -1;
    contacts += expect_same_contacts(world);
  }
  EXPECT_GT(cancelled, 20);
  EXPECT_GT(contacts, 20u);
}

/// Bug: what had been gathered was asked again, by the rules of then, as long as the bodies that may touch now went as
/// they did, although others in it had come to rest, or turned.
TEST(World, AgreesWhereSomeBodiesGoAnotherWayAndOthersGoOn) {
  const scenes::Shape unit = scenes::unit_cube(2);
  const Shape cube(Mesh(static_cast<Index>(unit.points.size()), unit.faces), unit.points);
  const auto slid = [](const Point& from, double by) {
    return Rigid{interpolated({from, {}}, {{from[0] + by, from[1], from[2]}, {}})};
  };
  const Point beside{1.02, 0.013, 0.017};
  const std::vector<BodyMotion> others{Static{{beside, {}}}, slid(beside, -0.001),
                                       Rigid{turned({beside, {}}, {0.003, 0.004, 0.005}, beside)}};
  for (const BodyMotion& before : others)
    for (const BodyMotion& since : others) {
      TestWorld world;
      const BodyId still = world.add(cube, Static{}), other = world.add(cube, before);
      world.add(cube, slid({4, 0, 0}, 0.001));
      world.add(cube, slid({5.5, 0.31, 0.27}, -1));
      EXPECT_GT(expect_same_contacts(world), 0u);
      world.move(other, since);
      expect_same_contacts(world);
      expect_same_first(world);
      world.move(still, slid({-0.02, 0, 0}, 0.005));
      expect_same_contacts(world);
    }
}

/// Nor does what the world is told between them.
TEST(World, AgreesWhateverIsToldBetweenQuestions) {
  TestWorld world = random_world(11, 3.5, Motions::any);
  Random random(12);
  std::set<BodyId> removed;
  std::size_t contacts = 0;
  for (int step = 0; step < 40; ++step) {
    SCOPED_TRACE(step);
    const BodyId body = random.below(static_cast<int>(world.bodies.size()));
    auto& told = world.bodies[place(body)];
    const Shape shape = told.shape;
    const int what = random.below(5);
    if (removed.contains(body)) {
      world.add(shape, random_motion(random, shape, 3.5, Motions::any));
    } else if (what == 0) {
      world.set_radius(body, 0.05 * random.below(3));
    } else if (what == 1) {
      told.is_there = !told.is_there;
      world.world.set_enabled(body, told.is_there);
    } else if (what == 2) {
      const BodyId other = (body + 1) % static_cast<BodyId>(world.bodies.size());
      if (removed.contains(other)) continue;
      world.kept_apart.insert({std::min(body, other), std::max(body, other)});
      world.world.set_may_touch(body, other, false);
    } else if (what == 3 && step % 3 == 0) {
      told.is_there = false;
      removed.insert(body);
      world.world.remove(body);
    } else {
      world.move(body, random_motion(random, shape, 3.5, Motions::any));
    }
    contacts += expect_same_contacts(world, {.min_separation = 0.02 * random.below(3)});
    if (step % 4 == 0) expect_same_first(world, {.min_separation = 0.01});
  }
  EXPECT_GT(removed.size(), 0u);
  EXPECT_GT(contacts, 500u);
}

TEST(World, AgreesAboutPairsAtRest) {
  std::size_t pairs = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 1.5, Motions::any);
    OneMesh mesh(world);
    const std::vector<NearPair>& expected = mesh.detector.pairs_within(mesh.start, 0.1);
    const std::vector<BodyNearPair> found = world.world.pairs_within(0.1);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(named(found[i]), named(expected[i], mesh));
      EXPECT_EQ(found[i].distance, expected[i].distance);
    }
    pairs += found.size();
  }
  EXPECT_GT(pairs, 1000u);
}

TEST(World, AgreesAboutIntersections) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    TestWorld world = random_world(seed, 1, Motions::any);
    OneMesh mesh(world);
    const auto body = [&](Index v) { return mesh.names[place(v)][0]; };
    const auto own = [&](Index v) { return mesh.names[place(v)][1]; };
    std::set<std::tuple<BodyId, Edge, BodyId, Face>> expected, found;
    for (const Intersection& one : mesh.detector.intersections(mesh.start)) {
      const BodyId of_edge = body(one.edge[0]), of_face = body(one.face[0]);
      const auto motion = [&](BodyId id) -> const BodyMotion& { return world.bodies[place(id)].motion; };
      if (of_edge == of_face && !std::holds_alternative<Deforming>(motion(of_edge))) continue;
      if (std::holds_alternative<Static>(motion(of_edge)) && std::holds_alternative<Static>(motion(of_face))) continue;
      expected.insert({of_edge,
                       {own(one.edge[0]), own(one.edge[1])},
                       of_face,
                       {own(one.face[0]), own(one.face[1]), own(one.face[2])}});
    }
    for (const BodyIntersection& one : world.world.intersections())
      found.insert({one.bodies[0], one.edge, one.bodies[1], one.face});
    EXPECT_EQ(found, expected);
    count += found.size();
  }
  EXPECT_GT(count, 100u);
}

TEST(World, AgreesAboutHowFarTheStepMayGo) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double fraction : {0.0, 0.1, 0.5}) {
      SCOPED_TRACE(seed);
      TestWorld world = random_world(seed, 6, Motions::straight);
      OneMesh mesh(world);
      const SafeStep expected = mesh.detector.safe_step(mesh.step(), fraction);
      const BodyStep found = world.world.safe_step(fraction);
      EXPECT_EQ(found.lower, expected.lower);
      ASSERT_EQ(found.pair.has_value(), expected.pair.has_value());
      if (found.pair) {
        EXPECT_EQ(named(*found.pair), named(*expected.pair, mesh));
      }
    }
  }
}

/// Where all are at one time of their path.
std::vector<Point> points_at(const RigidPath& path, double time) {
  std::vector<Index> all;
  for (Index v = 0; v < path.vertex_count(); ++v) all.push_back(v);
  std::vector<Point> points(all.size());
  std::vector<double> errors(all.size());
  path.points_at(time, all, points, errors);
  return points;
}

/// Samples of the way: until the step's end each pair keeps its part, and there the one that ends it has no more.
TEST(World, KeepsDistancesWhereBodiesTurn) {
  constexpr double kRounding = 1e-12, kSample = 0.4;
  int ended = 0, whole = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const auto& [part, gap] : {std::pair{0.0, 0.0}, {0.1, 0.0}, {0.3, 0.02}}) {
      const double keep = part, separation = gap;
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", keep " << keep);
      TestWorld world = random_world(seed, 6, Motions::any);
      OneMesh mesh(world);
      const BodyStep step = world.world.safe_step(keep, {.min_separation = separation});
      const auto kept = [&](const NearPair& pair) {
        const double start = distance_of({pair.kind, pair.vertices}, mesh.start).distance;
        return separation + keep * std::max(start - separation, 0.0);
      };
      for (int sample = 1; step.lower > 0 && sample <= 8; ++sample) {
        const std::vector<Point> points = points_at(mesh.path, step.lower * sample / 8);
        for (const NearPair& near : mesh.detector.pairs_within(points, kSample))
          ASSERT_GE(near.distance, kept(near) - kRounding) << sample;
      }
      EXPECT_EQ(step.pair.has_value(), step.lower < 1);
      if (!step.pair) {
        ++whole;
        continue;
      }
      ++ended;
      EXPECT_NEAR(step.upper, step.lower, 1e-8);
      const std::vector<Point> end = points_at(mesh.path, step.upper);
      double excess = 1;
      for (const NearPair& near : mesh.detector.pairs_within(end, 6))
        if (named(near, mesh) == named(*step.pair)) excess = near.distance - kept(near);
      EXPECT_LE(excess, 1e-7);
    }
  }
  EXPECT_GT(ended, 5);
  EXPECT_GT(whole, 0);
}

/// The tip of a rod of length 2 goes down to a floor below it, on an arc.
TEST(World, KnowsHowFarARodMayTurn) {
  const Shape rod(Mesh(2, {}, {{0, 1}}), {{0, 0, 0}, {2, 0, 0}});
  const Shape ground(Mesh(3, {{0, 1, 2}}), {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}});
  World world(one_thread());
  world.add(ground, Static{{{0, 0, -1}, {}}});
  world.add(rod, Rigid{interpolated({}, {{}, {0, 1, 0}})});
  for (const double keep : {0.0, 0.1, 0.5}) {
    const BodyStep step = world.safe_step(keep);
    EXPECT_NEAR(step.lower, std::asin((1 - keep) / 2), 1e-8);
    EXPECT_NEAR(step.upper, step.lower, 1e-8);
    ASSERT_TRUE(step.pair);
    EXPECT_NEAR(step.pair->distance, 1, 1e-14);
  }
}

}  // namespace
}  // namespace tamis::test
