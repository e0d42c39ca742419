// tamis scene: frames, and the check of what was written.
#include <gtest/gtest.h>

#include "command/tests/command.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/mesh/ply.hpp"

namespace tamis::test {
namespace {

constexpr const char* kRecord = "scene cloth-ball --triangles 600 --frames 2 --out frames --check";

TEST(SceneVerb, RecordsFramesThatAreProvenFreeOfIntersections) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(kRecord);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("checked         3 frames, 0 with intersections"), std::string::npos) << outcome.out;
  for (const char* frame : {"frame_0000.ply", "frame_0001.ply", "frame_0002.ply"})
    EXPECT_FALSE(bytes_of_file(folder.path() / "frames" / frame).empty()) << frame;
}

// Bug: a check of what is in memory, or one that sees nothing: here the cloth of a finished run is pulled through the
// floor.
TEST(SceneVerb, CheckFindsAFrameThatPassesThroughItself) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run(kRecord).code, 0);
  const auto file = folder.path() / "frames/frame_0001.ply";
  io::MeshFile frame = io::read_mesh(file);
  frame.positions.front()[2] = -1;  // a corner of the sheet, below the floor
  io::write_ply(file, frame);
  const Outcome outcome = folder.run(kRecord);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("3 frames, 1 with intersections"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("frame_0001.ply"), std::string::npos) << outcome.err;
}

TEST(SceneVerb, RefusesUnknownScenesAndSizes) {
  for (const char* arguments : {"scene moon --out frames", "scene bunny --triangles 3 --out frames", "scene airbag"})
    EXPECT_EQ(CommandFolder().run(arguments).code, 2) << arguments;
}

}  // namespace
}  // namespace tamis::test
