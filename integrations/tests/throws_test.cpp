// A few throws of the poster: none comes through, and Bullet alone stops some of them not.
#include <gtest/gtest.h>

#include "integrations/bullet/throws/body_scenes.hpp"
#include "integrations/bullet/throws/cloth.hpp"
#include "integrations/bullet/throws/independent.hpp"
#include "integrations/bullet/throws/scenes.hpp"

namespace tamis::bullet {
namespace {

void expect_none_through(const Scene& scene, Method method) {
  for (const Trial& trial : scene.trials) {
    const Flight flight = trial.arena->fly(method, trial.thrown);
    EXPECT_FALSE(trial.is_through(flight));
    EXPECT_EQ(touching_steps(*trial.arena, flight), 0);
    EXPECT_EQ(sampled_crossings(*trial.arena, flight, 4), 0);
  }
}

/// That the checks above can fail: what Bullet does alone is seen as what it is.
void expect_some_through(const Scene& scene, Method method) {
  int through = 0;
  for (const Trial& trial : scene.trials) {
    const Flight flight = trial.arena->fly(method, trial.thrown);
    through += trial.is_through(flight);
    EXPECT_TRUE(!trial.is_through(flight) || touching_steps(*trial.arena, flight) > 0);
  }
  EXPECT_GT(through, 0);
}

TEST(Throws, NoPlateComesThroughAClampedWorld) {
  const Scene plates = spinning_plates(5);
  expect_none_through(plates, Method::clamped_hull);
  expect_none_through(plates, Method::clamped_mesh);
  expect_some_through(plates, Method::mesh);
}

TEST(Throws, NoRodComesThroughAClampedWorld) {
  const Scene rods = spinning_rods(4);
  expect_none_through(rods, Method::clamped_hull);
  expect_none_through(rods, Method::clamped_mesh);
  expect_some_through(rods, Method::hull_ccd);
}

TEST(Throws, ASampleSeesABodyThatIsHalfThrough) {
  const Arena arena(wall(2, 1), box({0.1, 0.1, 0.1}), 0.1);
  Flight flight;
  for (const btScalar z : {1.0F, 0.0F}) flight.places.emplace_back(btQuaternion(0, 0, 0, 1), btVector3(0.3F, 0.2F, z));
  EXPECT_EQ(sampled_crossings(arena, flight, 1), 1);
  EXPECT_EQ(touching_steps(arena, flight), 1);
}

TEST(Pile, ComesToRestAGapApart) {
  constexpr int kPlates = 20;
  const BodyRun run = run_bodies(pile(kPlates, 0.0015), 30, true);
  EXPECT_EQ(touching_steps(run.bodies, run.places), 0);
  EXPECT_EQ(plates_inside(run), 0U);
  for (std::size_t plate = 1; plate <= kPlates; ++plate)
    EXPECT_NEAR(run.places.back()[plate].getOrigin().y(), 0.006 * static_cast<double>(plate) - 0.0025, 4e-4) << plate;
  EXPECT_LT(run.questions, 1.5);
}

TEST(Pile, OfPlatesThatFallFromAHeightOntoEachOtherStaysOne) {
  constexpr double kDrop = 0.05;
  const BodyRun run = run_bodies(pile(20, kDrop), 60, true);
  EXPECT_EQ(touching_steps(run.bodies, run.places), 0);
  EXPECT_EQ(plates_inside(run), 0U);
  const BodyRun alone = run_bodies(pile(20, kDrop), 60, false);
  EXPECT_GT(touching_steps(alone.bodies, alone.places), 0);
  EXPECT_GT(plates_inside(alone), 0U);
}

/// Bug: contacts on both sides pushed it, each by the missing part of a gap, and it jammed at the tube's mouth.
TEST(Peg, FallsInATubeThatIsTighterThanAGap) {
  for (const double clearance : {0.0002, 0.0006, 0.0012}) {
    const BodyRun run = run_bodies(peg_in_tube(clearance), 60, true);
    EXPECT_LT(peg_above_floor(run), 0.01) << clearance;
    EXPECT_EQ(touching_steps(run.bodies, run.places), 0) << clearance;
  }
}

TEST(Bodies, ComeToRestWithoutOverlapping) {
  const BodyRun mixed = run_bodies(mixed_bodies(1), 120, true);
  EXPECT_EQ(hanging(mixed), std::vector<std::size_t>{});
  EXPECT_EQ(overlapping(mixed), 0U);
  EXPECT_EQ(touching_steps(mixed.bodies, mixed.places), 0);
  EXPECT_GT(overlapping(run_bodies(mixed_bodies(1), 120, false)), 0U);
}

/// That the measure can fail: it sees a body that wants to fall and stays.
TEST(Bodies, AreSeenToHang) {
  BodyRun run = run_bodies(row_of_cubes(2), 50, true);
  EXPECT_EQ(hanging(run), std::vector<std::size_t>{});
  for (std::size_t i = 0; i < run.places.size(); ++i) {
    run.places[i][1] = run.places[0][1];
    run.velocities[i][1] = {0, -1, 0};
  }
  EXPECT_EQ(hanging(run), std::vector<std::size_t>{1});
  EXPECT_EQ(hanging_speed(run), 1);
}

TEST(Row, KeepsItsMomentum) {
  const auto [before, after] = momentum(run_bodies(row_of_cubes(2), 60, true));
  EXPECT_EQ(before, 5);
  EXPECT_NEAR(after, 5, 0.01);
}

TEST(Cloth, DoesNotPassThroughItselfWhereItIsTruncated) {
  EXPECT_EQ(touching_steps(run_cloth(31, 100, true)), 0);
  EXPECT_GT(touching_steps(run_cloth(31, 100, false)), 0);
}

TEST(Pile, IsSeenToSinkIntoItselfWithoutAClamp) {
  const BodyRun run = run_bodies(pile(6, 0.0015), 60, false);
  EXPECT_GT(plates_inside(run), 0U);
  EXPECT_GT(touching_steps(run.bodies, run.places), 0);
}

}  // namespace
}  // namespace tamis::bullet
