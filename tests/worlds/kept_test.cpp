// What a world keeps from one question to the next changes no answer.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tamis/error.hpp"
#include "worlds/expect_agreement.hpp"

namespace tamis::test {
namespace {

/// What is kept from one question to the next changes nothing.
TEST(World, AgreesStepAfterStep) {
  for_each_step([](TestWorld& world) { expect_same_contacts(world); });
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
      EXPECT_EQ(world.world.safe_step(0.2).toi_lower, mesh.detector.safe_step(mesh.step(), 0.2).toi_lower);
    }
  }
  EXPECT_GT(contacts, 5000u);
}

// Bug: two hierarchies are walked to the end, whoever waits.
TEST(World, CanBeCancelledWhileItLooksForWhatIsNear) {
  const scenes::Shape sphere = scenes::unit_sphere(40);
  std::vector<Point> inner = sphere.points;
  for (Point& p : inner)
    for (double& x : p) x *= 0.98;
  const Mesh mesh(static_cast<Index>(inner.size()), sphere.faces);
  long looks = 0;
  Options options;
  options.threads = 1;
  options.is_cancelled = [&] { return ++looks == 20; };  // what a question by itself asks less often
  World world(options);
  world.add(Shape(mesh, sphere.points), Static{});
  world.add(Shape(mesh, inner), Rigid{interpolated_chain({}, {{}, {0, 0, 3}})});
  EXPECT_THROW((void)world.is_free(), Cancelled);
  EXPECT_EQ(world.statistics().nodes_visited, 0) << "all was found before";
}

// Bug: what bodies said of an earlier question is added again, if this one does not ask them.
TEST(World, SaysOfAQuestionWhatItAloneHasCost) {
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.5}, {0.4, 0.2, 0.5}, {0.2, 0.4, 0.5}};
  std::vector<Point> end = start;
  for (std::size_t v = 3; v < 6; ++v) end[v][2] = -0.5;
  const Shape shape(Mesh(6, {{0, 1, 2}, {3, 4, 5}}), start);
  const auto cost = [](const World& world) {
    std::uint64_t pairs = world.statistics().nodes_visited;
    for (const StageCount& stage : world.statistics().stages) pairs += stage.vf + stage.ee;
    return pairs;
  };
  World kept, fresh;
  for (World* world : {&kept, &fresh})
    for (int i = 0; i < 3; ++i) world->add(shape, Deforming{start, end});
  static_cast<void>(kept.contacts());
  EXPECT_FALSE(kept.is_free());
  EXPECT_FALSE(fresh.is_free());
  EXPECT_EQ(cost(kept), cost(fresh));
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
      Rigid{interpolated_chain(at(0), at(1))});
  std::size_t contacts = 0;
  for (int step = 0; step < 10; ++step) {
    SCOPED_TRACE(step);
    world.move(bowl, Rigid{interpolated_chain(at(step), at(step + 1))});
    for (int looks = 0; looks < 5; ++looks) {
      looks_left = looks;
      try {
        (void)world.world.contacts();
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

/// Bug: where edges together are longer than any double, what had been gathered was taken to hold all that comes near,
/// also of bodies that were added since.
TEST(World, AgreesWhereEdgesAreAsLongAsDoubles) {
  const Shape plate(Mesh(3, {{0, 1, 2}}), {{-0x1p1022, 0, 0}, {0x1p1023, 0, 0}, {0, 0x1p1023, 0}});
  const auto down = [](double from, double to) {
    return Rigid{interpolated_chain({{0, 0, from}, {}}, {{0, 0, to}, {}})};
  };
  World world(one_thread());
  world.add(plate, Static{});
  world.add(plate, down(1, -1));
  const std::size_t of_two = world.contacts().size();
  EXPECT_GT(of_two, 0u);
  world.add(plate, down(3, -4));
  EXPECT_EQ(world.contacts().size(), 3 * of_two);
}

/// Bug: bodies that had been near before, and went far since, had others looked at that hardly move, and of which it
/// cannot be told whether they keep so little.
TEST(World, SafeStepsAreThoseOfANewOneWhoeverWasNearBefore) {
  const Point u{0.8, 0.6, 0}, v{-0.36, 0.48, 0.8}, up{0.48, -0.64, 0.6};
  const auto at_places = [&](double a, double b, double c) {
    Point p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = a * u[k] + b * v[k] + c * up[k];
    return p;
  };
  const Shape plate(Mesh(3, {{0, 1, 2}}), {at_places(1, 0, 0), at_places(0, 1, 0), at_places(-1, -1, 0)});
  const Shape tetrahedron(Mesh(4, {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}),
                          {{0, 0, 0}, at_places(0.3, 0, 1), at_places(0, 0.3, 1), at_places(-0.3, -0.3, 1)});
  const auto flies = [&](double above) {
    const Point from = at_places(0, 0, above);
    return Rigid{turned_chain({from, {}}, {0.1, 0, 0}, {from[0] + 1e3, from[1], from[2]})};
  };
  const Point rests = at_places(0, 0, 1e-14);
  World kept(one_thread()), fresh(one_thread());
  for (World* world : {&kept, &fresh}) {
    world->add(plate, Static{});
    world->add(tetrahedron, Rigid{turned_chain({rests, {}}, {1e-16, 0, 0}, rests)});
  }
  kept.add(tetrahedron, flies(3));
  (void)kept.safe_step(0.1);
  kept.move(2, flies(1e12));
  fresh.add(tetrahedron, flies(1e12));
  const BodyStep expected = fresh.safe_step(0.1), step = kept.safe_step(0.1);
  EXPECT_EQ(step.toi_lower, expected.toi_lower);
  EXPECT_EQ(step.toi_upper, expected.toi_upper);
}

/// Bug: what had been gathered was asked again, by the rules of then, as long as the bodies that may touch now went as
/// they did, although others in it had come to rest, or turned.
TEST(World, AgreesWhereSomeBodiesGoAnotherWayAndOthersGoOn) {
  const scenes::Shape unit = scenes::unit_cube(2);
  const Shape cube(Mesh(static_cast<Index>(unit.points.size()), unit.faces), unit.points);
  const auto slid = [](const Point& from, double by) {
    return Rigid{interpolated_chain({from, {}}, {{from[0] + by, from[1], from[2]}, {}})};
  };
  const Point beside{1.02, 0.013, 0.017};
  const std::vector<BodyMotion> others{Static{{beside, {}}}, slid(beside, -0.001),
                                       Rigid{turned_chain({beside, {}}, {0.003, 0.004, 0.005}, beside)}};
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

/// What was gathered for one distance must not serve a farther one without its margin.
TEST(World, FindsWhatIsFartherAfterWhatIsNear) {
  World kept(one_thread());
  const auto fill = [](World& world) {
    world.add(SlidingSheet::sheet(40), Static{});
    world.add(Shape(Mesh(3, {{0, 1, 2}}), {{0, 0, 0.01}, {0.1, 0, 0.01}, {0, 0.1, 0.01}}),
              Rigid{interpolated_chain({}, {})});
  };
  fill(kept);
  for (const double distance : {0.02, 0.03, 1.5, 0.05, 3.0}) {
    World fresh(one_thread());
    fill(fresh);
    const auto expected = fresh.pairs_within(distance);
    EXPECT_GT(expected.size(), 0U);
    EXPECT_EQ(kept.pairs_within(distance).size(), expected.size()) << distance;
  }
}

}  // namespace
}  // namespace tamis::test
