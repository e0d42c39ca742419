#include "scenes/simulation/scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "scenes/simulation/simulator.hpp"
#include "scenes/simulation/tests/intersection.hpp"
#include "support/threads.hpp"
#include "tamis/error.hpp"

namespace tamis::simulation {
namespace {

constexpr Index kAboutTriangles = 1500;

class EveryScene : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (std::string_view(GetParam()) == "bunny" && !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj"))
      GTEST_SKIP() << "the Debian package glmark2-data is not installed";
  }
  static Model make(std::uint64_t seed = 1) { return simulated_scene(GetParam()).make(kAboutTriangles, seed); }
};

std::vector<Point> mesh_positions(const Simulator& simulator) {
  std::vector<Point> points;
  const Points& x = simulator.particles().position;
  for (Index v = 0; v < simulator.model().mesh_vertices(); ++v) points.push_back({x(0, v), x(1, v), x(2, v)});
  return points;
}

TEST(Crossings, AreFoundWhereTheyAre) {
  const std::vector<Face> faces{{0, 1, 2}, {3, 4, 5}};
  const std::vector<Point> apart{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.1}, {0.3, 0.2, 1}, {0.2, 0.3, 1}};
  std::vector<Point> through = apart;
  through[3][2] = -0.1;
  EXPECT_FALSE(test::find_crossing(apart, faces));
  EXPECT_TRUE(test::find_crossing(through, faces));
}

// Bug: a fold, a wheel or a lattice that starts intersecting, or far from the size asked for.
TEST_P(EveryScene, StartsFreeOfIntersectionsAtTheSizeAskedFor) {
  const Simulator simulator(make());
  EXPECT_FALSE(test::find_crossing(mesh_positions(simulator), simulator.model().faces));
  EXPECT_NEAR(static_cast<double>(simulator.model().faces.size()), kAboutTriangles, 0.15 * kAboutTriangles);
}

// Bug: a scene that is fine at the size of the tests and starts intersecting at its own (edge collapses of the bunny).
TEST_P(EveryScene, StartsAtItsFullSize) {
  const SimulatedScene& scene = simulated_scene(GetParam());
  const Model model = scene.make(scene.triangles, 1);
  EXPECT_NEAR(static_cast<double>(model.faces.size()), scene.triangles, 0.05 * scene.triangles);
  EXPECT_NO_THROW(Simulator{model});
}

// Bug: any hole in the proof of the substeps shows up as cloth that has passed through something.
TEST_P(EveryScene, KeepsEveryFrameFreeOfIntersections) {
  Simulator simulator(make());
  std::uint64_t touches = 0;
  for (int frame = 0; frame < 12; ++frame) {
    simulator.advance();
    touches += simulator.effort().touches;
    ASSERT_FALSE(test::find_crossing(mesh_positions(simulator), simulator.model().faces)) << "frame " << frame;
    ASSERT_LT(simulator.particles().position.cwiseAbs().maxCoeff(), 10) << "something exploded";
  }
  EXPECT_GT(touches, 0U) << "nothing touches: the scene tests nothing";
}

// Bug: an order of threads, or memory left over, that leaks into the result.
TEST_P(EveryScene, GivesTheSameBitsWithOneThreadAndWithMany) {
  Simulator many(make()), one(make());
  for (int frame = 0; frame < 3; ++frame) {
    many.advance();
    const test::AllowedThreads one_thread(1);
    one.advance();
    ASSERT_EQ(many.particles().position, one.particles().position) << "frame " << frame;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::Values("airbag", "cloth-ball", "funnel", "bunny"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::erase(name, '-');
                           return name;
                         });

// Bug: a seed that changes nothing, or everything.
TEST(Scenes, TheSeedCreasesTheClothALittle) {
  const Points a = cloth_ball(kAboutTriangles, 1).particles.position,
               b = cloth_ball(kAboutTriangles, 2).particles.position;
  EXPECT_GT((a - b).norm(), 0);
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 0.05);
}

TEST(Scenes, AnUnknownNameNamesTheChoices) {
  try {
    simulated_scene("teapot");
    FAIL();
  } catch (const InvalidOptions& error) {
    EXPECT_NE(std::string(error.what()).find("cloth-ball"), std::string::npos);
  }
}

// Bug: surfaces that touch at the start could never be kept apart, and no substep could be proven.
TEST(Scenes, ASimulatorRefusesSurfacesThatTouchAtTheStart) {
  Model model;
  const Surface sheet = square(2, 1);
  model.add_cloth(sheet, sheet, {0.2, 1000, 0});
  model.add_cloth(mapped(sheet,
                         [](const Vec& p) -> Vec {
                           return {p.z() + 0.1, p.x(), p.y()};
                         }),
                  sheet, {0.2, 1000, 0});
  EXPECT_THROW(Simulator{std::move(model)}, Error);
}

}  // namespace
}  // namespace tamis::simulation
