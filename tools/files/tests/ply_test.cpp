#include "files/mesh/ply.hpp"

#include <gtest/gtest.h>

#include "files/error.hpp"
#include "files/tests/ply_builder.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

using test::Encoding;
using test::PlyBuilder;

class EveryEncoding : public testing::TestWithParam<Encoding> {};

INSTANTIATE_TEST_SUITE_P(Ply, EveryEncoding, testing::Values(Encoding::ascii, Encoding::little, Encoding::big),
                         [](const auto& encoding) { return std::string(test::name_of(encoding.param)); });

// Bug: a coordinate passes through float, or bytes are swapped the wrong way.
TEST_P(EveryEncoding, KeepsEveryBitOfADouble) {
  const MeshFile mesh = parse_ply(test::two_triangles(GetParam()), "m.ply");
  ASSERT_EQ(mesh.positions.size(), 4u);
  const double expected[] = {0.1, 1.0 / 3, -2.5e-300, 1e300};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.positions[i], (Point{expected[i], 2 * expected[i], -expected[i]}));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{1, 2, 3}, {0, 2, 3}}));
  EXPECT_TRUE(mesh.notes.empty());
}

// Bug: one of the sixteen type names is unknown, or its size or sign is wrong.
TEST_P(EveryEncoding, ReadsEveryScalarTypeAsCoordinateAndAsIndex) {
  for (const char* type : {"char", "int8", "uchar", "uint8", "short", "int16", "ushort", "uint16", "int", "int32",
                           "uint", "uint32", "float", "float32", "double", "float64"}) {
    const double low = type[0] == 'u' ? 200 : -100;
    PlyBuilder ply(GetParam());
    ply.header("element vertex 3");
    for (const char* axis : {"x", "y", "z"}) ply.header(std::string("property ") + type + " " + axis);
    ply.header("element face 1").header(std::string("property list uint8 ") + type + " vertex_index").end_header();
    for (int v = 0; v < 3; ++v) ply.value(type, v).value(type, low).value(type, 7).end_row();
    ply.value("uint8", 3).value(type, 2).value(type, 0).value(type, 1).end_row();
    const MeshFile mesh = parse_ply(ply.text(), "m.ply");
    EXPECT_EQ(mesh.positions, (std::vector<Point>{{0, low, 7}, {1, low, 7}, {2, low, 7}})) << type;
    EXPECT_EQ(mesh.faces, (std::vector<Face>{{2, 0, 1}})) << type;
  }
}

// Bug: a list's length is read as one byte whatever its type.
TEST_P(EveryEncoding, ReadsEveryIntegerTypeAsLengthOfAList) {
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint"}) {
    PlyBuilder ply(GetParam());
    ply.header("element vertex 3").header("property float x").header("property float y").header("property float z");
    ply.header("element face 1").header(std::string("property list ") + type + " int vertex_indices").end_header();
    for (int v = 0; v < 3; ++v) ply.value("float", v).value("float", 0).value("float", 0).end_row();
    ply.value(type, 3).value("int", 0).value("int", 1).value("int", 2).end_row();
    EXPECT_EQ(parse_ply(ply.text(), "m.ply").faces.size(), 1u) << type;
  }
}

// Bug: colours, normals, texture lists or unknown elements shift what follows; elements in another order are refused.
TEST_P(EveryEncoding, SkipsWhatItDoesNotKnowAndTakesElementsInAnyOrder) {
  PlyBuilder ply(GetParam());
  ply.header("comment made by hand").header("obj_info none");
  ply.header("element camera 1").header("property float focus").header("property list uchar short marks");
  ply.header("element edge 1").header("property uchar red").header("property int vertex1");
  ply.header("property int vertex2");
  ply.header("element face 1").header("property list uchar float texture");
  ply.header("property list uchar int vertex_indices").header("property int flags");
  ply.header("element vertex 3").header("property uchar red").header("property double z").header("property double x");
  ply.header("property list int int ring").header("property double y").end_header();
  ply.value("float", 1).value("uchar", 2).value("short", 5).value("short", 6).end_row();
  ply.value("uchar", 9).value("int", 2).value("int", 0).end_row();
  ply.value("uchar", 1).value("float", 0.5).value("uchar", 3).value("int", 0).value("int", 1).value("int", 2);
  ply.value("int", 4).end_row();
  for (int v = 0; v < 3; ++v)
    ply.value("uchar", 255)
        .value("double", 30 + v)
        .value("double", 10 + v)
        .value("int", 1)
        .value("int", 77)
        .value("double", 20 + v)
        .end_row();
  const MeshFile mesh = parse_ply(ply.text(), "m.ply");
  EXPECT_EQ(mesh.positions, (std::vector<Point>{{10, 20, 30}, {11, 21, 31}, {12, 22, 32}}));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}}));
  EXPECT_EQ(mesh.loose_edges, (std::vector<Edge>{{2, 0}}));
  EXPECT_EQ(mesh.notes, (std::vector<std::string>{"element 'camera' was skipped"}));
}

// Bug: a fan that starts at the wrong corner, or polygons cut, crossed or without area, without a word.
TEST_P(EveryEncoding, CutsPolygonsIntoTrianglesAndSaysSo) {
  PlyBuilder ply(GetParam());
  ply.header("element vertex 5").header("property float x").header("property float y").header("property float z");
  ply.header("element face 2").header("property list uchar int vertex_indices").end_header();
  for (int v = 0; v < 5; ++v) ply.value("float", v).value("float", 0).value("float", 0).end_row();
  ply.value("uchar", 3).value("int", 0).value("int", 1).value("int", 2).end_row();
  ply.value("uchar", 5);
  for (const int v : {4, 3, 2, 1, 0}) ply.value("int", v);
  ply.end_row();
  const MeshFile mesh = parse_ply(ply.text(), "m.ply");
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {4, 3, 2}, {4, 2, 1}, {4, 1, 0}}));
  EXPECT_EQ(mesh.notes,
            (std::vector<std::string>{"1 polygon of more than three corners was cut into triangles",
                                      "1 polygon crosses itself or has no area, the first joins vertices 4, 3, 2, 1, "
                                      "0: their triangles may overlap, correct them"}));
}

// Bug: strips, as range scanners write them, are skipped or wound every second time the other way.
TEST_P(EveryEncoding, ReadsStripsOfTriangles) {
  for (const auto& [type, end] : {std::pair("int", -1.0), std::pair("uint", 4294967295.0)}) {
    PlyBuilder ply(GetParam());
    ply.header("element vertex 6").header("property float x").header("property float y").header("property float z");
    ply.header("element tristrips 1").header("property list int " + std::string(type) + " vertex_indices").end_header();
    for (int v = 0; v < 6; ++v) ply.value("float", v / 2).value("float", v % 2).value("float", 0).end_row();
    ply.value("int", 12);
    for (const double v : {0.0, 1.0, 2.0, 3.0, 3.0, 4.0, end, 2.0, 3.0, 4.0, end, 5.0}) ply.value(type, v);
    ply.end_row();
    const MeshFile mesh = parse_ply(ply.text(), "m.ply");
    EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    EXPECT_TRUE(mesh.notes.empty());
  }
}

// Bug: files from Windows are refused.
TEST(Ply, ReadsLinesThatEndInCarriageReturns) {
  std::string text = test::two_triangles(Encoding::ascii);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
  EXPECT_TRUE(looks_like_ply(text));
  EXPECT_EQ(parse_ply(text, "m.ply").faces.size(), 2u);
}

// Bug: denormal numbers, or a plus sign, are taken for bad numbers by the parser underneath.
TEST(Ply, ReadsTinyAndSignedNumbersInText) {
  const MeshFile mesh = parse_ply(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n"
      "5e-324 1e-400 +2.5\n",
      "m.ply");
  EXPECT_EQ(mesh.positions, (std::vector<Point>{{5e-324, 0, 2.5}}));
}

// Bug: the writer loses bits, edges, points or the order of faces.
TEST(Ply, WritesWhatItReads) {
  const test::TemporaryFolder folder;
  MeshFile mesh = parse_ply(test::two_triangles(Encoding::big), "m.ply");
  mesh.loose_edges = {{0, 3}};
  mesh.loose_points = {2, 1};
  write_ply(folder.path() / "copy.ply", mesh);
  const MeshFile copy = read_mesh(folder.path() / "copy.ply");
  EXPECT_EQ(copy.positions, mesh.positions);
  EXPECT_EQ(copy.faces, mesh.faces);
  EXPECT_EQ(copy.loose_edges, mesh.loose_edges);
  EXPECT_EQ(copy.loose_points, mesh.loose_points);
}

// Bug: what another program calls a point is taken for a vertex number, or an index out of range for a vertex.
TEST(Ply, LoosePointsNameVertices) {
  const std::string two =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
      "element point 1\nproperty int ";
  const std::string rows = "end_header\n0 0 0\n1 1 1\n";
  const MeshFile ours = parse_ply(two + "vertex\n" + rows + "1\n", "m.ply");
  EXPECT_EQ(ours.loose_points, (std::vector<Index>{1}));
  EXPECT_TRUE(ours.notes.empty());
  const MeshFile theirs = parse_ply(two + "colour\n" + rows + "7\n", "m.ply");
  EXPECT_TRUE(theirs.loose_points.empty());
  EXPECT_EQ(theirs.notes.size(), 1u);
  EXPECT_THROW(parse_ply(two + "vertex\n" + rows + "2\n", "m.ply"), FileError);
}

}  // namespace
}  // namespace tamis::io
