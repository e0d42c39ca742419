// The frame in which boxes are floats follows the whole scene. No answer may depend on it, wherever the rest of the
// scene is.
#include <gtest/gtest.h>

#include "distributed/tests/same_answers.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

Scene cloth() { return scenes::scene_by_name("folded-cloth", 300, 1); }

// Bug: the frame is then about the rest, the finest part of the scene, and each rank took that of its own part.
TEST(FarVertices, SomeFlyOff) {
  Scene scene = cloth();
  for (const std::size_t v : {7u, 50u, 101u}) scene.end[v][v % 3] += 1000;
  expect_same_for_all_cuts(scene);
}

// Bug: the frame then moves with the scene, by its boxes at both ends of the step, of which ranks knew only the hull.
TEST(FarVertices, AllGoFarTogether) {
  Scene scene = scenes::scene_by_name("soup", 300, 1);
  for (Point& p : scene.end) p[0] += 100, p[1] -= 37;
  expect_same_for_all_cuts(scene);
}

TEST(FarVertices, TheFinestPartIsOnOneRank) {
  Scene scene = cloth();
  const auto count = static_cast<Index>(scene.start.size());
  const std::vector<Face> faces = scene.faces;
  for (Index v = 0; v < count; ++v) {
    const Point start = scene.start[static_cast<std::size_t>(v)], end = scene.end[static_cast<std::size_t>(v)];
    const auto enlarged = [](const Point& p) { return Point{1000 * p[0], 1000 * p[1], 1000 * p[2] + 5000}; };
    scene.add_vertex(enlarged(start), enlarged(end), 1);
  }
  for (const auto& [a, b, c] : faces) scene.faces.push_back({a + count, b + count, c + count});
  expect_same_for_all_cuts(scene);
}

// A kept detector whose own part stands still, while the frame changes with what others do.
TEST(FarVertices, OthersGoFartherFromStepToStep) {
  Scene scene = cloth();
  Detector one(scene.mesh(), one_thread());
  Part part = part_of(scene, cuts()[0]);
  distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
  for (int step = 0; step < 3; ++step) {
    expect_same_answers(answers_of(one, scene), many, part, "step " + std::to_string(step));
    scene.end[0][1] += 1 + 300 * step;
    part.move(scene.start, scene.end);
  }
}

// As Mesh::components numbers them; one process takes it, too.
TEST(FarVertices, AVertexThatNothingUsesIsInNoGroup) {
  Scene scene = cloth();
  scene.add_vertex({1e6, 0, 0}, {0, 1e6, 0}, -1);
  Options options = one_thread();
  options.filter.group_of_vertex = scene.group_of_vertex;
  options.filter.group_count = 2;
  options.filter.groups_may_touch = {1, 1, 1, 1};
  expect_same_for_all_cuts(scene, options);
}

}  // namespace
}  // namespace tamis::test
