// The surface and the motion that the author of the files meant.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "command/tests/command.hpp"

namespace tamis::test {
namespace {

class Surface : public CommandTest {
 protected:
  bool notes(const std::string& arguments, const std::string& says) const {
    return folder_.run(arguments).err.find(says) != std::string::npos;
  }
};

constexpr const char* kL = "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n";

/// Two triangles of a square whose common side is listed twice; `part`: how far one copy of a corner is from the other.
std::string split_square(double x, double part = 0) {
  const auto at = [&](double dx, double dy) {
    return "v " + std::to_string(x + dx) + " " + std::to_string(dy) + " 0\n";
  };
  return at(0, 0) + at(1, 0) + at(0, 1) + at(1, 0) + at(1, 1) + at(0, 1 + part) + "f 1 2 3\nf 4 5 6\n";
}

// Bug: a concave polygon is cut as a fan, which passes through itself and fills its notch.
TEST_F(Surface, ConcavePolygonsKeepTheirNotch) {
  folder_.write("l.obj", std::string(kL) + "f 1 2 3 4 5 6\n");
  EXPECT_EQ(folder_.run("intersections l.obj --json").json()["intersections"], 0);
  for (const auto& [name, z] : {std::pair("start.obj", "1"), {"end.obj", "-1"}})
    folder_.write(name, kL + std::string("v 1.2 1.2 ") + z + "\nf 1 2 3 4 5 6\np 7\n");
  EXPECT_EQ(folder_.run("is-free start.obj end.obj").code, 0);
  for (const auto& [name, z] : {std::pair("start.obj", "1"), {"end.obj", "-1"}})
    folder_.write(name, kL + std::string("v 0.8 0.8 ") + z + "\nf 1 2 3 4 5 6\np 7\n");
  EXPECT_EQ(folder_.run("is-free start.obj end.obj").code, 1);
}

// Bug: the end of a step has other triangles than its start, where a polygon is concave in one of them.
TEST_F(Surface, AStepHasTheTrianglesOfItsStart) {
  const std::string rest = "v 0 2 0\nf 1 2 3 4\n";
  folder_.write("convex.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\n" + rest);
  folder_.write("concave.obj", "v 0 0 0\nv 0.5 0.5 0\nv 2 2 0\n" + rest);
  for (const char* step : {"convex.obj concave.obj", "concave.obj convex.obj"})
    EXPECT_LE(folder_.run(std::string("contacts ") + step).code, 0) << step;
}

// Bug: copies of vertices touch each other, and nothing says why, or how to join them.
TEST_F(Surface, VerticesAtOnePlaceAreCountedAndWelded) {
  folder_.write("a.obj", split_square(0));
  folder_.write("b.obj", split_square(5));
  EXPECT_EQ(folder_.run("info a.obj --json").json()["coincident_vertices"], 2);
  EXPECT_EQ(folder_.run("info a.obj --json --weld").json()["coincident_vertices"], 0);
  const std::string says = "2 of 6 vertices lie exactly on another one";
  for (const char* question :
       {"intersections a.obj", "contacts a.obj b.obj", "earliest a.obj b.obj", "safe-step a.obj b.obj",
        "is-free a.obj b.obj", "truncate a.obj b.obj", "sequence a.obj b.obj", "audit a.obj b.obj",
        "within a.obj --distance 0", "view a.obj b.obj", "is-free a.obj b.obj --check-start"}) {
    EXPECT_TRUE(notes(question, says)) << question;
    const Outcome welded = folder_.run(question + std::string(" --weld"));
    EXPECT_NE(welded.err.find("--weld joined 2 vertices"), std::string::npos) << question << welded.err;
    EXPECT_EQ(welded.err.find(says), std::string::npos) << question;
    EXPECT_EQ(welded.code, 0) << question;
  }
  EXPECT_EQ(folder_.run("is-free --weld a.obj b.obj").code, 0);
  EXPECT_EQ(folder_.run("is-free --weld=0 a.obj b.obj").code, 0);
  expect_refused("info a.obj --weld -1", "--weld");
}

// Bug: joining changes the motion: vertices that part are joined, or those within a distance are not.
TEST_F(Surface, OnlyWhatStaysTogetherIsWelded) {
  folder_.write("a.obj", split_square(0));
  folder_.write("b.obj", split_square(0, 0.25));
  folder_.write("c.obj", split_square(0));
  for (const char* question : {"contacts a.obj b.obj", "sequence a.obj b.obj c.obj"}) {
    EXPECT_TRUE(notes(question + std::string(" --weld"),
                      "--weld joined 1 vertex to others; 1 more part in a later frame, and stay apart"))
        << question;
    EXPECT_TRUE(notes(question + std::string(" --weld 0.3"), "--weld joined 2 vertices to others\n")) << question;
  }
}

// Bug: a vertex of a scanner that nothing uses is refused, or spoils sums.
TEST_F(Surface, NotFiniteVerticesThatNothingUsesAreCounted) {
  const std::string triangle = "v 1 0 0\nv 0 1 0\nf 1 3 4\n";
  folder_.write("a.obj", "v 0 0 0\nv nan 0 inf\n" + triangle);
  folder_.write("b.obj", "v 0 0 1\nv nan 0 inf\n" + triangle);
  const auto facts = folder_.run("info a.obj --json").json();
  EXPECT_EQ(facts["not_finite_vertices"], 1);
  EXPECT_EQ(facts["unused_vertices"], 1);
  EXPECT_EQ(folder_.run("truncate a.obj b.obj --json --scale 2").json()["part_of_way"], 1);
  for (const char* question :
       {"intersections a.obj", "is-free a.obj b.obj", "audit a.obj b.obj", "view a.obj b.obj --out page.html",
        "contacts a.obj b.obj --out step.glb", "contacts a.obj b.obj --out step.vtp"})
    EXPECT_EQ(folder_.run(question).code, 0) << question;
}

// Bug: six digits hide that a box far from the origin is a metre wide.
TEST_F(Surface, BoxesShowTheirWidth) {
  folder_.write("far.obj", "v 449999.5 5199999.5 300\nv 450000.5 5199999.5 300\nv 450000.5 5200000.5 300\nf 1 2 3\n");
  EXPECT_NE(folder_.run("info far.obj").out.find("(449999.5, 5199999.5, 300) to (450000.5, 5200000.5, 300)"),
            std::string::npos);
  EXPECT_EQ(folder_.run("info far.obj").err, "");
}

// Bug: floats that are coarser than the edges change the surface without a word.
TEST_F(Surface, CoarseCoordinatesAreNoted) {
  const auto ply = [](const char* type) {
    std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n";
    for (const char* axis : {"x", "y", "z"}) header += "property " + std::string(type) + " " + axis + "\n";
    return header +
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "5200000 0 0\n5200001 0 0\n5200000 1 0\n3 0 1 2\n";
  };
  folder_.write("float.ply", ply("float"));
  folder_.write("double.ply", ply("double"));
  EXPECT_TRUE(notes("info float.ply", "float32 numbers are up to 0.5 apart here; 3 sides"));
  EXPECT_FALSE(notes("info double.ply", "note"));
}

// Bug: a step from metres to millimetres is answered without a word.
TEST_F(Surface, OtherUnitsAreNoted) {
  folder_.write("1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder_.write("2.obj", "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nf 1 2 3\n");
  folder_.write("3.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
  for (const char* question :
       {"is-free 1.obj 2.obj", "contacts 1.obj 2.obj", "sequence 1.obj 2.obj", "audit 1.obj 2.obj"})
    EXPECT_TRUE(notes(question, "2.obj: the mesh is 1e+03 times as large as at the start")) << question;
  EXPECT_TRUE(notes("is-free 2.obj 1.obj", "1.obj: the mesh is 1e+03 times as small"));
  EXPECT_FALSE(notes("is-free 1.obj 3.obj", "times as"));
}

// Bug: a step that leads over missing frames is called proven.
TEST_F(Surface, NoStepLeadsOverMissingFrames) {
  for (const int i : {1, 2, 4}) folder_.write_frame("f" + std::to_string(i) + ".obj", i);
  const std::string says = "frame 3 is missing before this one: no step leads here";
  for (const char* question : {"is-free 'f*.obj'", "sequence .", "audit ."})
    EXPECT_TRUE(notes(question, says)) << question;
  EXPECT_EQ(folder_.run("is-free 'f*.obj' --json").json()["steps"], 1);
  EXPECT_EQ(folder_.run("sequence . --json").json()["steps"].size(), 1u);
  expect_refused("view 'f*.obj'", says);
  folder_.write("scene.json", R"({"bodies": [{"frames": ["f*.obj"]}]})");
  expect_refused("bodies scene.json", says);
  EXPECT_EQ(folder_.run("is-free f2.obj f4.obj --json").json()["steps"], 1);
}

// Bug: a folder whose name has brackets hides its frames.
TEST_F(Surface, BracketsInNamesOfFoldersAreNoPattern) {
  folder_.write_frame("run[3]/1.obj", 1);
  folder_.write_frame("run[3]/2.obj", 2);
  folder_.write_frame("run3/7.obj", 1);
  folder_.write_frame("take[1]_1.obj", 1);
  folder_.write_frame("take[1]_2.obj", 2);
  EXPECT_EQ(folder_.run("is-free 'run[3]/*.obj' --json").json()["steps"], 1);
  EXPECT_EQ(folder_.run("is-free 'take[1]_*.obj' --json").json()["steps"], 1);
}

// Bug: "no edge touches a triangle, proven" of two triangles that lie on each other at their common edge.
TEST_F(Surface, FlatFoldsAreNoIntersectionsButCounted) {
  folder_.write("folded.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.2 0.3 0\nf 1 2 3\nf 2 1 4\n");
  EXPECT_NE(folder_.run("intersections folded.obj").out.find("a triangle that shares no vertex with it"),
            std::string::npos);
  EXPECT_EQ(folder_.run("info folded.obj --json").json()["flat_folds"], 1);
  folder_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.2 -0.3 0\nf 1 2 3\nf 2 1 4\nf 3 1 2\n");
  EXPECT_EQ(folder_.run("info flat.obj --json").json()["flat_folds"], 0);
  folder_.write("nearly.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.2 0.3 1e-300\nf 1 2 3\nf 2 1 4\n");
  EXPECT_EQ(folder_.run("info nearly.obj --json").json()["flat_folds"], 0);
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int i = 3; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

// Bug: a point cache whose times go back is asked about without a word.
TEST_F(Surface, TimesOfACacheThatGoBackAreNoted) {
  std::string cache = big_endian(3) + big_endian(3);
  const auto add = [&](float x) { cache += big_endian(std::bit_cast<std::uint32_t>(x)); };
  for (const float time : {0.0f, 0.5f, 0.25f}) add(time);
  for (int frame = 0; frame < 3; ++frame)
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) add(x);
  folder_.write("a.mdd", cache);
  folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(notes("audit a.obj a.mdd", "0.25 s: its time does not come after 0.5 s"));
}

}  // namespace
}  // namespace tamis::test
