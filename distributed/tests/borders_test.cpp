// Features that belong together, on different ranks: what one rank alone would take for loose, for apart or for one.
#include <gtest/gtest.h>

#include <algorithm>

#include "distributed/tests/same_answers.hpp"
#include "support/copied.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

Scene two_triangles() {
  Scene scene;
  for (const double z : {0.0, 1.0})
    for (const Point& p : {Point{0, 0, z}, Point{1, 0, z}, Point{0, 1, z}})
      scene.add_vertex(p, {p[0], p[1], 0.25 - 0.5 * z}, z > 0 ? 1 : 0);
  scene.faces = {{0, 1, 2}, {3, 4, 5}};
  return scene;
}

TEST(Borders, MoreRanksThanTriangles) { expect_same_for_all_cuts(two_triangles()); }

TEST(Borders, TrianglesGivenSeveralTimesHaveTheirContactsAsOften) {
  Scene scene = two_triangles();
  for (int copy = 0; copy < 5; ++copy) scene.faces.push_back(scene.faces[static_cast<std::size_t>(copy % 2)]);
  ASSERT_GT(contacts_of(Detector(scene.mesh()), scene.step()).size(),
            contacts_of(Detector(two_triangles().mesh()), scene.step()).size());
  expect_same_for_all_cuts(scene);
}

// Taken for loose, they would meet the loose point and edge below: pairs that one process does not have.
TEST(Borders, LooseFeaturesThatBelongToTrianglesOfOtherRanksAreNotLoose) {
  Scene scene = two_triangles();
  const Index a = scene.add_vertex({0.5, 0, 0.5}, {0.5, 0, -0.5}, 2);
  const Index b = scene.add_vertex({0.5, -1, 0.5}, {0.5, -1, -0.5}, 2);
  const Index c = scene.add_vertex({0.5, 0, 2}, {0.5, 0, -2}, 3);
  scene.loose_points = {c, 3, 0};
  scene.loose_edges = {{a, b}, {1, 0}, {4, 3}, {c, c}};
  const auto contacts = contacts_of(Detector(scene.mesh()), scene.step());
  ASSERT_TRUE(std::ranges::any_of(contacts, [](const Contact& x) { return x.kind == PairKind::vertex_edge; }));
  expect_same_for_all_cuts(scene);
}

TEST(Borders, AVertexOnBothRanksIsOneVertex) {
  // A strip folded on itself: neighbours share vertices, and must not be in contact wherever the strip is cut.
  Scene scene;
  for (int i = 0; i < 40; ++i) {
    const double x = 0.1 * (i / 2 % 10), y = i % 2, z = 0.05 * (i / 20);
    scene.add_vertex({x, y, z}, {x, y, i / 20 == 1 ? -0.05 : 0}, 0);
  }
  for (Index v = 0; v + 2 < 40; ++v) scene.faces.push_back({v, v + 1, v + 2});
  expect_same_for_all_cuts(scene);
}

// Bug: the gap of two boxes grows by more than the largest double; they were taken for apart but at the start, and
// the contact was lost.
TEST(Borders, WhatPartsByMoreThanAnyDouble) {
  constexpr double kUnit = 1e308;
  Scene scene;
  const auto add = [&](const Point& p, const Point& way, Index group) {
    const auto scaled = [](const Point& x) { return Point{kUnit * x[0], kUnit * x[1], kUnit * x[2]}; };
    scene.add_vertex(scaled(p), scaled({p[0] + way[0], p[1] + way[1], p[2] + way[2]}), group);
  };
  for (const Point& p : {Point{-0.4, -0.4, 0}, Point{0.8, -0.4, 0}, Point{0.2, 0.8, 0}}) add(p, {-1.3, 0, 0}, 0);
  for (const Point& p : {Point{-0.4, 0.8, 0.1}, Point{0.8, 0.8, 0.1}, Point{0.2, -0.4, 0.1}}) add(p, {0.9, 0, -0.7}, 1);
  scene.faces = {{0, 1, 2}, {3, 4, 5}};
  ASSERT_FALSE(Detector(scene.mesh()).is_free(scene.step()));
  expect_same_for_all_cuts(scene);
}

TEST(Borders, ContactsGoToTheRankThatGivesTheirFirstVertex) {
  const Scene scene = scenes::scene_by_name("soup", 300, 4);
  const Part part = part_of(scene, cuts()[2]);  // vertex v on rank v mod size
  distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
  for (const Contact& contact : many.contacts(part.step())) EXPECT_EQ(contact.vertices[0] % rank_count(), rank_of());
}

TEST(Borders, TheFirstQuestionMayBeAny) {
  const Scene scene = scenes::scene_by_name("colliding-bodies", 400, 4);
  const Part part = part_of(scene, cuts()[0]);
  const SafeStep one = Detector(scene.mesh()).safe_step(scene.step(), 0.2);
  const SafeStep many = distributed::Detector(MPI_COMM_WORLD, part.mesh, one_thread()).safe_step(part.step(), 0.2);
  expect_same(one, many, "safe_step");
}

TEST(Borders, StatisticsSayWhatWasDone) {
  const Scene scene = scenes::scene_by_name("folded-cloth", 3000, 1);
  const Part part = part_of(scene, cuts()[0]);
  distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
  (void)many.contacts(part.step());
  const auto of_all = [](std::uint64_t number) {
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return number;
  };
  const std::uint64_t owned = of_all(many.statistics().owned), pairs = of_all(many.statistics().pairs_tested);
  EXPECT_EQ(owned, scene.faces.size());
  Detector one(scene.mesh());
  (void)one.contacts(scene.step());
  // Which boxes are found to meet depends on the trees; a pair that the clip leaves meets in every tree.
  const auto& stages = one.statistics().stages;
  const StageCount &boxes = stages[0], &clipped = stages[2];
  ASSERT_EQ(boxes.name, "boxes");
  ASSERT_EQ(clipped.name, "dnf");
  EXPECT_GE(pairs, clipped.vf + clipped.ee);
  EXPECT_LT(static_cast<double>(pairs), 1.5 * static_cast<double>(boxes.vf + boxes.ee));
  EXPECT_LT(many.balance().owned, 1.1);
  EXPECT_EQ(of_all(many.statistics().borrowed) == 0, rank_count() == 1);
}

}  // namespace
}  // namespace tamis::test
