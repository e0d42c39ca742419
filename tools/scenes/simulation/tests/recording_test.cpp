#include "scenes/simulation/recording.hpp"

#include <gtest/gtest.h>

#include "files/mesh/mesh_file.hpp"
#include "support/temporary_folder.hpp"
#include "tamis/error.hpp"

namespace tamis::simulation {
namespace {

constexpr Index kTriangles = 700;

void record_to(const std::filesystem::path& folder, int frames, std::uint64_t seed = 1) {
  record(simulated_scene("cloth-ball"), {folder, frames, kTriangles, seed}, [](const Simulator&) {});
}

// Bug: a velocity, a clock or a hidden state that an interrupted run loses.
TEST(Recording, AnInterruptedRunGoesOnBitForBit) {
  const test::TemporaryFolder folder;
  record_to(folder.path() / "whole", 12);
  for (int frames : {0, 5, 8, 12}) record_to(folder.path() / "parts", frames);
  for (int frame = 0; frame <= 12; ++frame)
    EXPECT_EQ(test::bytes_of_file(frame_path(folder.path() / "whole", frame)),
              test::bytes_of_file(frame_path(folder.path() / "parts", frame)))
        << "frame " << frame;
}

// Bug: frames that drop digits, or particles that are no vertices.
TEST(Recording, FramesHoldTheMeshInDoubles) {
  const test::TemporaryFolder folder;
  record_to(folder.path(), 0);
  const io::MeshFile frame = io::read_mesh(frame_path(folder.path(), 0));
  const Model model = cloth_ball(kTriangles, 1);
  EXPECT_EQ(frame.faces, model.faces);
  ASSERT_EQ(static_cast<Index>(frame.positions.size()), model.mesh_vertices());
  for (Index v = 0; v < model.mesh_vertices(); ++v)
    EXPECT_EQ(Vec(frame.positions[static_cast<std::size_t>(v)].data()), Vec(model.particles.position.col(v)));
}

// Bug: two runs mixed in one folder.
TEST(Recording, AFolderOfAnotherRunIsRefused) {
  const test::TemporaryFolder folder;
  record_to(folder.path(), 1);
  EXPECT_THROW(record_to(folder.path(), 2, 7), Error);
}

// Bug: interrupted after its first frame, before its first state, a run takes its own frame for another's.
TEST(Recording, GoesOnFromAnyMoment) {
  const test::TemporaryFolder folder;
  const SimulatedScene& scene = simulated_scene("funnel");
  const Recording recording{folder.path(), 1, 600, 1};
  record(scene, {folder.path(), 0, 600, 1}, [](const Simulator&) {});
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "state.bin"));
  folder.write("frame_0001.ply", "written, and then the power was cut");
  EXPECT_NO_THROW(record(scene, recording, [](const Simulator&) {}));
  EXPECT_GT(std::filesystem::file_size(folder.path() / "frame_0001.ply"), 1000u);
}

// Bug: going on from half a state.
TEST(Recording, ADamagedStateIsRefused) {
  const test::TemporaryFolder folder;
  record_to(folder.path(), 1);
  const std::string state = test::bytes_of_file(folder.path() / "state.bin");
  folder.write("state.bin", std::string_view(state).substr(0, state.size() / 2));
  EXPECT_THROW(record_to(folder.path(), 2), Error);
}

// Bug: somebody's frames written over.
TEST(Recording, FramesWithoutAStateAreNotWrittenOver) {
  const test::TemporaryFolder folder;
  record_to(folder.path(), 1);
  std::filesystem::remove(folder.path() / "state.bin");
  EXPECT_THROW(record_to(folder.path(), 1), Error);
}

}  // namespace
}  // namespace tamis::simulation
