// The clamp without an engine: bodies with poses that a table says.
#include "integrations/clamp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "integrations/carriers.hpp"
#include "tamis/error.hpp"

namespace tamis::adapters {
namespace {

/// One triangle of size 2, flat.
Shape plate() { return {Mesh(3, {{0, 1, 2}}), {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}; }

Pose at_height(double z) { return {{0, 0, z}, {}}; }

/// Ways straight from a pose to another, in doubles, in a second.
class Table : public WantedStep {
 public:
  void add(BodyId body, const Pose& from, const Pose& to) {
    ids_.push_back(body);
    ways_[body] = {from, to};
  }
  std::span<const BodyId> moving() const override { return ids_; }
  const Shape& shape(BodyId body) const override { return body == of_parts ? parts : one_; }
  double seconds() const override { return 1; }
  Pose pose(BodyId body, double fraction) const override {
    const auto known = ways_.find(body);
    if (known == ways_.end()) return {};
    Pose pose = known->second.first;
    pose.position = plus(pose.position, times(fraction, way_of(body)));
    return pose;
  }
  Inertia inertia(BodyId) const override { return {{1, 1, 1}, {}}; }
  double friction(const BodyPair&) const override { return 0; }
  Velocity velocity(BodyId body) const override { return {way_of(body), {}}; }
  Velocity way(BodyId body) const override { return velocity(body); }
  void set_way(BodyId body, const Velocity& way) override {
    ways_.at(body).second.position = plus(ways_.at(body).first.position, way.linear);
  }
  double radius(BodyId) const override { return std::sqrt(2.0); }
  bool collides(const BodyPair& bodies) const override { return !apart.contains(bodies); }
  bool collides_at(const std::array<BodyId, 2>& bodies, const std::array<Index, 2>& vertices) const override {
    return !std::ranges::any_of(std::array{0U, 1U},
                                [&](std::size_t i) { return bodies[i] == of_parts && vertices[i] < parts_from; });
  }

  std::set<BodyPair> apart;
  BodyId of_parts = -1;  ///< of which vertices before `parts_from` collide with nobody
  Index parts_from = 0;
  Shape parts = plate();  ///< of that body

 private:
  Point way_of(BodyId body) const {
    const auto known = ways_.find(body);
    return known == ways_.end() ? Point{} : minus(known->second.second.position, known->second.first.position);
  }

  Shape one_ = plate();
  std::vector<BodyId> ids_;
  std::map<BodyId, std::pair<Pose, Pose>> ways_;
};

/// Bug: bodies that were told their ways before another body's way was refused kept them, and were asked about there.
TEST(Clamp, LeavesTheWorldAsItWasIfAWayIsRefused) {
  World world;
  Table step;
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  const BodyId goes = world.add(plate(), resting(at_height(1))), lost = world.add(plate(), resting(at_height(9)));
  step.add(goes, at_height(1), at_height(-3));
  step.add(lost, at_height(9), at_height(nowhere));
  EXPECT_THROW((void)clamp(world, step, {}), Error);
  for (const auto& [body, height] : {std::pair(goes, 1.0), std::pair(lost, 9.0)})
    EXPECT_EQ(pose_at(std::get<Rigid>(world.motion(body)).chain, 1).position, at_height(height).position);
}

TEST(Clamp, StopsABodyAGapBeforeWhatItWouldHit) {
  World world;
  world.add(plate(), Static{});
  Table step;
  step.add(world.add(plate(), Static{at_height(1)}), at_height(1), at_height(-3));
  const ClampedStep clamped = clamp(world, step, {overlapping(world), {}}, {.gap = 0.01});
  ASSERT_EQ(clamped.ends.size(), 1U);
  EXPECT_NEAR(1 - 4 * clamped.ends[0].fraction, 0.01, 1e-3);
  EXPECT_TRUE(world.is_free());
  ASSERT_FALSE(clamped.limits.empty());
  EXPECT_NEAR(clamped.limits[0].toi_lower, 0.25, 1e-3);
}

/// Remembers the most pairs that a question decided before the clamp asked who collides.
class Counting final : public Table {
 public:
  explicit Counting(const World& world) : world_(world) {}
  bool collides(const BodyPair& bodies) const override {
    const PrecisionCount& by = world_.statistics().decided_by;
    most = std::max(most, by.lanes + by.scalar + by.exact);
    return Table::collides(bodies);
  }
  mutable std::uint64_t most = 0;

 private:
  const World& world_;
};

/// 800 triangles in waves.
Shape waves() {
  constexpr Index kSide = 21;
  std::vector<Point> points;
  std::vector<Face> faces;
  for (Index i = 0; i < kSide; ++i)
    for (Index j = 0; j < kSide; ++j) points.push_back({0.1 * i, 0.1 * j, 0.03 * std::sin(7. * i + 11. * j)});
  for (Index a = 0; a + kSide + 1 < kSide * kSide; ++a)
    if (a % kSide != kSide - 1) faces.insert(faces.end(), {{a, a + kSide, a + 1}, {a + 1, a + kSide, a + kSide + 1}});
  return {Mesh(kSide * kSide, faces), points};
}

/// Bug: all contacts of two bodies were asked for, which takes seconds where fine meshes pass through each other.
TEST(Clamp, DecidesFewPairsOfFineBodies) {
  World world;
  world.add(waves(), Static{});
  Counting step(world);
  const Pose start{{0.137, 0.061, 1}, {}}, end{{0.137, 0.061, -3}, {}};
  step.add(world.add(waves(), Static{start}), start, end);
  static_cast<void>(clamp(world, step, {}, {.gap = 0.01}));
  EXPECT_TRUE(world.is_free());
  EXPECT_GT(step.most, 0u);
  EXPECT_LT(step.most, 200u);
  world.move(1, Rigid{chain_between(start, end)});
  EXPECT_GT(world.contacts().size(), 2000u);
}

TEST(Clamp, LetsGoWhoTouchesNobody) {
  World world;
  world.add(plate(), Static{});
  Table step;
  step.add(world.add(plate(), Static{at_height(1)}), at_height(1), at_height(-3));
  step.add(world.add(plate(), Static{at_height(9)}), at_height(9), at_height(4));
  const ClampedStep clamped = clamp(world, step, {});
  EXPECT_LT(clamped.ends[0].fraction, 0.25);
  EXPECT_EQ(clamped.ends[1].fraction, 1);
}

/// The lowest is stopped by the floor, so that the others meet who would have moved out of their way.
TEST(Clamp, StopsWhoMeetsABodyThatWasStopped) {
  World world;
  world.add(plate(), Static{});
  Table step;
  for (int i = 1; i <= 5; ++i) step.add(world.add(plate(), Static{at_height(i)}), at_height(i), at_height(i - 20));
  const ClampedStep clamped = clamp(world, step, {}, {.gap = 0.01, .rounds = 2});
  EXPECT_TRUE(world.is_free());
  EXPECT_GT(clamped.questions, 1);
  EXPECT_GT(clamped.ends[0].fraction, 0);
  for (std::size_t i = 1; i < 5; ++i)
    EXPECT_LT(20 * clamped.ends[i - 1].fraction, 20 * clamped.ends[i].fraction + 1)
        << "body " << i << " passed the one below";
}

/// Bodies of a table that are near each other when its step begins.
Beginning near(World& world, const Table& step, const ClampOptions& options) {
  for (const BodyId body : step.moving()) world.move(body, resting(step.pose(body, 0)));
  return beginning(world, step, options);
}

/// Two above each other and the floor, a gap and a half each; their ways are as long as 100 gaps.
Table falling(World& world, double gap) {
  world.add(plate(), Static{});
  Table step;
  for (const double height : {1.5 * gap, 3 * gap})
    step.add(world.add(plate(), Static{at_height(height)}), at_height(height), at_height(height - 100 * gap));
  return step;
}

/// Bug: without an engine's own list of near places a body came to a thousandth of a gap, and kept its speed.
TEST(Clamp, TakesTheSpeedOfWhoLiesOnAnother) {
  World world;
  const ClampOptions options{.gap = 0.01};
  Table step = falling(world, options.gap);
  const ClampedStep clamped = clamp(world, step, near(world, step, options), options);
  EXPECT_EQ(clamped.questions, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyId body = step.moving()[i];
    const double height = step.pose(body, clamped.ends[i].fraction).position[2];
    EXPECT_NEAR(height, 0.01 * static_cast<double>(i + 1), 1e-4) << "each a gap above the one below";
    EXPECT_NEAR(clamped.ends[i].velocity.linear[2], -0.005 * static_cast<double>(i + 1), 1e-4);
  }
}

TEST(Clamp, PartsBodiesNearerThanAGapWithoutSpeed) {
  World world;
  world.add(plate(), Static{});
  const ClampOptions options{.gap = 0.01};
  Table step;
  step.add(world.add(plate(), Static{at_height(4e-4)}), at_height(4e-4), at_height(-1));
  const ClampedStep clamped = clamp(world, step, near(world, step, options), options);
  EXPECT_GT(step.pose(step.moving()[0], clamped.ends[0].fraction).position[2], 1e-3);
  EXPECT_NEAR(clamped.ends[0].velocity.linear[2], 0, 1e-9);
}

/// Two bodies that are so near each other, at no place where one carries the other.
Beginning at_distance(const BodyPair& bodies, double distance) { return {{}, {{bodies, NearBodies{distance, {}}}}}; }

TEST(Clamp, LetsStandWhoIsKnownToBeTooNear) {
  World world;
  const BodyId floor = world.add(plate(), Static{});
  Table step;
  step.add(world.add(plate(), Static{at_height(4e-4)}), at_height(4e-4), at_height(-1));
  EXPECT_GT(clamp(world, step, {}, {.gap = 0.01}).ends[0].fraction, 0);
  const Beginning near = at_distance({floor, step.moving()[0]}, 4e-4);
  const ClampedStep clamped = clamp(world, step, near, {.gap = 0.01});
  EXPECT_EQ(clamped.ends[0].fraction, 0);
  EXPECT_NEAR(clamped.ends[0].velocity.linear[2], 0, 1e-9) << "the speed with which it met the floor";
}

/// Bug: it stood, step after step, while gravity added to the speed with which it wanted to go on.
TEST(Clamp, LetsGoWhoIsTooNearAndMeetsLate) {
  World world;
  const BodyId floor = world.add(plate(), Static{});
  Table step;
  const Pose start = at_height(4e-4), end{{0.5, 0, -1e-3}, {}};
  step.add(world.add(plate(), Static{start}), start, end);
  EXPECT_GT(clamp(world, step, at_distance({floor, step.moving()[0]}, 4e-4), {.gap = 0.01}).ends[0].fraction, 0.1);
}

/// A body that could be seen when the step began, and is stopped, does not want to go on.
TEST(Clamp, StopsTheSpeedAtWhichBodiesMeet) {
  Table step;
  Velocities velocities{{0, {{0, 0, -3}, {}}}, {1, {{0, 0, 1}, {}}}};
  step.add(0, at_height(1), at_height(-2));
  step.add(1, at_height(0), at_height(1));
  Carriers::stop({{0, 1}, {{{0, 0, 1}, {0, 0, 0}}}, {0, 0, 1}}, step, velocities);
  EXPECT_EQ(velocities.at(0).linear[2], -1);
  EXPECT_EQ(velocities.at(1).linear[2], -1);
}

TEST(Clamp, NeverHoldsBackWhoOverlapsOnAccountOfEachOther) {
  World world;
  const Pose upright{{0, 0, 0}, {1.5, 0, 0}}, gone{{0, 0, 3}, {1.5, 0, 0}};
  const BodyId flat = world.add(plate(), Static{}), through = world.add(plate(), resting(upright));
  const std::set<BodyPair> pairs = overlapping(world);
  EXPECT_EQ(pairs, (std::set<BodyPair>{{flat, through}}));
  Table step;
  step.add(through, upright, gone);
  EXPECT_EQ(clamp(world, step, {pairs, {}}).ends[0].fraction, 1);
}

TEST(Clamp, DoesNotStopWhomTheEngineDoesNotCollide) {
  World world;
  const BodyId floor = world.add(plate(), Static{}), falling = world.add(plate(), Static{at_height(1)});
  Table step;
  step.add(falling, at_height(1), at_height(-3));
  step.apart = {{floor, falling}};
  EXPECT_EQ(clamp(world, step, {}).ends[0].fraction, 1);
}

/// Bug: all are asked for ever, as nobody can be held back.
/// The bug: a part that collides with nobody held its body back, and where it reached through another body, all parts
/// passed that as well.
TEST(Clamp, LooksAtPartsThatCollideAlone) {
  std::vector<Point> points{{0, -1, -2}, {0, -1, 2}, {0, 1, 0}};  // upright, through the floor
  for (const double z : {0.0, 1.0}) points.insert(points.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
  World world;
  world.add(plate(), Static{});
  Table step;
  step.parts = {Mesh(9, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}), points};
  step.of_parts = world.add(step.parts, resting(at_height(0.5)));
  step.add(step.of_parts, at_height(0.5), at_height(-4));
  step.parts_from = 6;
  EXPECT_EQ(overlapping(world).size(), 1U);
  EXPECT_TRUE(overlapping(world, step).empty());
  const ClampedStep clamped = clamp(world, step, {overlapping(world, step), {}}, {.gap = 0.01});
  EXPECT_NEAR(1.5 - 4.5 * clamped.ends.at(0).fraction, 0.01, 1e-3);  // the last part is a gap above the floor
}

TEST(Clamp, RefusesBodiesThatMeetWithoutBeingAskedToMove) {
  World world;
  Table step;
  world.add(plate(), Static{});
  world.add(plate(), Rigid{chain_between(at_height(1), at_height(-3))});
  EXPECT_THROW((void)clamp(world, step, {}), InvalidStep);
}

TEST(Clamp, RefusesAGapOrRoundsOutOfRange) {
  World world;
  Table step;
  EXPECT_THROW((void)clamp(world, step, {}, {.gap = 0}), InvalidOptions);
  EXPECT_THROW((void)clamp(world, step, {}, {.gap = std::nan("")}), InvalidOptions);
  EXPECT_THROW((void)clamp(world, step, {}, {.rounds = -1}), InvalidOptions);
}

}  // namespace
}  // namespace tamis::adapters
