#include "files/mesh/obj.hpp"

#include <gtest/gtest.h>

#include <clocale>

#include "files/tests/messages.hpp"

namespace tamis::io {
namespace {

const std::string kFour = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

// Bug: a corner's texture or normal index is taken for a vertex, or counting starts at 0.
TEST(Obj, ReadsEveryFormOfCorner) {
  const MeshFile mesh =
      parse_obj(kFour + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 2/1 3/1 4/1\nf 1//1 3//1 4//1\nf 4/1/1 1/1/1 2/1/1\n", "m.obj");
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {1, 2, 3}, {0, 2, 3}, {3, 0, 1}}));
  EXPECT_TRUE(mesh.notes.empty());
}

// Bug: negative indices count from the end of the file instead of from where they stand.
TEST(Obj, NegativeIndicesCountBackFromTheirLine) {
  const MeshFile mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -1 -2 -3\n", "m.obj");
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {3, 2, 1}}));
}

// Bug: rods and points are dropped.
TEST(Obj, PolylinesBecomeLooseEdgesAndPointsLoosePoints) {
  const MeshFile mesh = parse_obj(kFour + "l 1 2 -1\np 3 4\n", "m.obj");
  EXPECT_EQ(mesh.loose_edges, (std::vector<Edge>{{0, 1}, {1, 3}}));
  EXPECT_EQ(mesh.loose_points, (std::vector<Index>{2, 3}));
}

// Bug: polygons are cut without a word; comments, continued lines, colours or vertices after the face upset the parser.
TEST(Obj, TakesWhatPeopleWrite) {
  const MeshFile mesh = parse_obj(
      "# comment\nmtllib a.mtl\no thing\n f 1 2 \\\n 3 4 # a square\r\ns off\n\nv 0 0 0 1 0 0\nv 1e0 +.5 -.25 1\nv 1 1 "
      "0\nv 0 1 0\n",
      "m.obj");
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.positions[1], (Point{1, 0.5, -0.25}));
  ASSERT_EQ(mesh.notes.size(), 2u);
  EXPECT_TRUE(test::contains(mesh.notes[0], "1 polygon"));
  EXPECT_TRUE(test::contains(mesh.notes[1], "1 polygon is not flat, the first joins vertices 0, 1, 2, 3"));
}

// Bug: a folder's name in a comment takes the next line with it, so that all indices mean other vertices.
TEST(Obj, ACommentEndsWithItsLine) {
  const MeshFile mesh = parse_obj("  # from C:\\scenes\\\nv 9 9 9 # here, too: \\\n" + kFour + "f 1 2 3\n", "m.obj");
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[0], (Point{9, 9, 9}));
}

// Bug: after a comment or a group's name that ends in CR alone the next statement is lost: a face is missing, in
// silence.
TEST(Obj, ALineMayEndInCrAlone) {
  std::string text = "# made by a\ro thing\r" + kFour + "g one\rf 1 2 3\nusemtl red\r\rf 2 3 4\r";
  const MeshFile mesh = parse_obj(text, "m.obj");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {1, 2, 3}}));
  EXPECT_TRUE(mesh.notes.empty());
  EXPECT_TRUE(test::contains(test::file_error("m.obj", [&] { parse_obj(text += "f 9 2 3\r", "m.obj"); }), "line 12"));
}

// Bug: where numbers have a comma, one that is too small for a double is read up to its point.
TEST(Obj, NumbersAreTheSameInEveryCountry) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* country : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"})
    if (std::setlocale(LC_NUMERIC, country)) break;
  const MeshFile mesh = parse_obj("v 1.5e-400 -1.5e-400 1.5\nf 1 1 1\n", "m.obj");
  const std::string message = test::file_error("m.obj", [] { parse_obj("v 1.5e400 0 0\nf 1 1 1\n", "m.obj"); });
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(mesh.positions[0], (Point{0, 0, 1.5}));
  EXPECT_TRUE(test::contains(message, "coordinate x is not finite")) << message;
}

TEST(Obj, SaysThatFreeFormSurfacesAndOpenEndsAreNotMeshes) {
  const MeshFile mesh = parse_obj(kFour + "cstype bezier\nsurf 0 1 0 1 1 2 3 4\nend\nf 1 2 3", "m.obj");
  EXPECT_EQ(mesh.faces.size(), 1u);
  ASSERT_EQ(mesh.notes.size(), 2u);
  EXPECT_TRUE(test::contains(mesh.notes[1], "a part of the surface is missing")) << mesh.notes[1];
  EXPECT_TRUE(test::contains(mesh.notes[1], "1 line was skipped, the first in line 6: 'surf'")) << mesh.notes[1];
}

// Bug: a vendor's own words refuse the file, or are skipped without a word.
TEST(Obj, SkipsWordsOfOtherProgramsWithOneNote) {
  const MeshFile mesh = parse_obj(kFour + "t 0 0\nvw 0.5\nxyz\nf 1 2 3\n", "m.obj");
  EXPECT_EQ(mesh.faces.size(), 1u);
  EXPECT_EQ(
      mesh.notes,
      (std::vector<std::string>{"of words that OBJ does not have, 3 lines were skipped, the first in line 5: 't'"}));
}

// Bug: a scanner's vertex that nothing uses refuses the file.
TEST(Obj, AVertexThatNothingUsesNeedsNoCoordinates) {
  const MeshFile mesh = parse_obj("v nan inf nan\n" + kFour + "f 2 3 4\n", "m.obj");
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{1, 2, 3}}));
  for (const char* use : {"f 1 2 3\n", "l 1 2\n", "p 1\n", "f 2 3 4 1\n"})
    EXPECT_THROW(parse_obj("v nan inf nan\n" + kFour + use, "m.obj"), FileError) << use;
}

// Bug: any of these is accepted, or the message does not lead to the line.
TEST(Obj, EachErrorNamesItsLine) {
  const std::pair<std::string, std::string> cases[] = {
      {"v 0 0\n", "line 1: a vertex needs three"},
      {"v 0 0 x\n", "line 1: 'x' is not a number"},
      {"v 0 0 inf\nf 1 1 1\n", "line 1: coordinate z is not finite"},
      {"v 0 0 0 v 5 5 5\n", "line 1: 'v' is not a number"},
      {kFour + "f 1 2\n", "line 5: a face needs three"},
      {kFour + "f 0 1 2\n", "line 5: '0' names no vertex"},
      {kFour + "f 1 2 5\nf 1 2 3\n", "line 5: vertex 5 is named, but the file has only 4"},
      {kFour + "f 1 2 -5\n", "line 5: '-5' names no vertex"},
      {kFour + "f 1 2 3.5\n", "'3.5' names no vertex"},
      {kFour + "f 1 2 99999999999999999999\n", "names no vertex"},
      {kFour + "l 1\n", "line 5: a line needs two"},
  };
  for (const auto& [text, says] : cases) {
    const std::string message = test::file_error("m.obj", [&, &bytes = text] { parse_obj(bytes, "m.obj"); });
    EXPECT_TRUE(test::contains(message, says)) << message << "\nshould say: " << says;
  }
}

}  // namespace
}  // namespace tamis::io
