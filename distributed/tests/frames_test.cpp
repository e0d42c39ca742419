// Recorded frames, cut in ways that are kind and unkind.
#include <gtest/gtest.h>

#include "distributed/tests/same_answers.hpp"
#include "files/mesh/mesh_file.hpp"
#include "search/topology/mean_edge.hpp"
#include "support/test_data.hpp"

namespace tamis::test {
namespace {

scenes::Scene scene_of(const std::filesystem::path& start, const std::filesystem::path& end) {
  io::MeshFile first = io::read_mesh(start);
  scenes::Scene scene;
  scene.start = std::move(first.positions);
  scene.end = io::read_mesh(end).positions;
  scene.faces = std::move(first.faces);
  scene.loose_edges = std::move(first.loose_edges);
  scene.group_of_vertex.assign(scene.start.size(), 0);
  return scene;
}

void expect_same_for(const char* start, const char* end, std::initializer_list<std::size_t> of_cuts) {
  const auto folder = data_folder();
  if (folder.empty()) GTEST_SKIP() << kNoData;
  const scenes::Scene scene = scene_of(folder / "frames" / start, folder / "frames" / end);
  Detector one(scene.mesh(), one_thread());
  const OneAnswers expected = answers_of(one, scene, 0.1 * mean_edge(one.mesh(), scene.start));
  for (const std::size_t cut : of_cuts) {
    const Part part = part_of(scene, cuts()[cut]);
    distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
    expect_same_answers(expected, many, part, cuts()[cut].name);
  }
}

TEST(Frames, ClothFunnel) { expect_same_for("cloth-funnel/227.ply", "cloth-funnel/228.ply", {0, 1, 2, 3}); }
TEST(Frames, ClothBall) { expect_same_for("cloth-ball/cloth_ball92.ply", "cloth-ball/cloth_ball93.ply", {2}); }
TEST(Frames, Kick) { expect_same_for("kick/frame_62.ply", "kick/frame_63.ply", {0}); }

}  // namespace
}  // namespace tamis::test
