#include "files/mesh/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "files/mesh/mesh_formats.hpp"
#include "files/tests/messages.hpp"
#include "files/tests/ply_builder.hpp"
#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

class MeshFiles : public testing::Test {
 protected:
  std::string error_of(const std::filesystem::path& path) {
    return test::file_error(path.string(), [&] { read_mesh(path); });
  }
  test::TemporaryFolder folder_;
};

// Bug: a PLY is recognised by its name alone.
TEST_F(MeshFiles, TellsFormatsByContentThenByName) {
  const std::string ply = test::two_triangles(test::Encoding::little);
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(read_mesh(folder_.write("a.dat", ply)).faces.size(), 2u);
  EXPECT_EQ(read_mesh(folder_.write("a.OBJ", obj)).faces.size(), 1u);
  EXPECT_EQ(read_mesh(folder_.write("off.dat", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).faces.size(), 1u);
  EXPECT_TRUE(test::contains(error_of(folder_.write("a.dat", "cube\n")), "not " + mesh_format_names()));
  EXPECT_TRUE(test::contains(error_of(folder_.write("b.ply", obj)), "line 1"));
}

// Bug: a text from an editor that marks UTF-8, or ends lines in CR, is refused as no mesh.
TEST_F(MeshFiles, TakesTextsOfEveryEditor) {
  const std::string mark = "\xef\xbb\xbf", obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::string ply = test::two_triangles(test::Encoding::ascii);
  EXPECT_EQ(read_mesh(folder_.write("a.obj", mark + obj)).faces.size(), 1u);
  EXPECT_EQ(read_mesh(folder_.write("a.ply", mark + ply)).faces.size(), 2u);
  std::replace(ply.begin(), ply.end(), '\n', '\r');
  EXPECT_EQ(read_mesh(folder_.write("b.ply", ply)).faces.size(), 2u);
  EXPECT_TRUE(test::contains(error_of(folder_.write("mark.obj", mark)), "the file is empty"));
}

// Bug: a file of another format is refused with an advice that does not help.
TEST_F(MeshFiles, SaysWhatReadsOtherFormats) {
  const std::pair<const char*, const char*> cases[] = {{"a.glb", "tamis.audit in Python reads it"},
                                                       {"a.abc", "Alembic is not read: export"},
                                                       {"a.vtk", "convert it"},
                                                       {"a.mdd", "together with a mesh file"},
                                                       {"a.xyz", "convert it, or give its name the ending"}};
  for (const auto& [name, says] : cases) {
    const std::string message = error_of(folder_.write(name, "what it holds\n"));
    EXPECT_TRUE(test::contains(message, says)) << message;
  }
  const std::string wide("v\0 \0000\0", 8);
  for (const std::string& text : {"\xff\xfe" + wide, wide, std::string("\0v\0 ", 4)}) {
    const std::string message = error_of(folder_.write("wide.obj", text));
    EXPECT_TRUE(test::contains(message, "UTF-16: save it as UTF-8")) << message;
  }
}

// Bug: a cloud of points in a foreign element is refused without naming the element.
TEST_F(MeshFiles, NamesWhatWasSkippedWhereNothingIsLeft) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "element range_grid 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0\n";
  const std::string message = error_of(folder_.write("scan.ply", ply));
  EXPECT_TRUE(test::contains(message, "no face and no edge in it (element 'range_grid' was skipped)")) << message;
}

// Bug: an empty mesh passes for one without contacts.
TEST_F(MeshFiles, RefusesFilesWithoutAMesh) {
  EXPECT_TRUE(test::contains(error_of(folder_.write("empty.ply", "")), "the file is empty"));
  EXPECT_TRUE(test::contains(error_of(folder_.write("blank.obj", "# nothing\n")), "no vertex"));
  EXPECT_TRUE(test::contains(error_of(folder_.write("cloud.obj", "v 0 0 0\n")), "no face and no edge"));
  EXPECT_TRUE(test::contains(error_of(folder_.path() / "absent.ply"), "cannot be read"));
  EXPECT_TRUE(test::contains(error_of(folder_.path()), "cannot be read"));
}

// Bug: frames of two meshes are paired up and indices mean different features.
TEST_F(MeshFiles, ComparesTopologiesAndNamesTheFirstDifference) {
  const MeshFile mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 2, 3}}, {{0, 3}}, {}, {}};
  const auto message = [&](const MeshFile& other) {
    return test::file_error("b", [&] { require_same_mesh(mesh, "a", other, "b"); });
  };
  EXPECT_NO_THROW(require_same_mesh(mesh, "a", mesh, "b"));
  MeshFile other = mesh;
  other.positions.pop_back();
  EXPECT_TRUE(test::contains(message(other), "3 vertices, but a has 4"));
  other = mesh;
  other.faces[1] = {2, 1, 3};
  EXPECT_TRUE(test::contains(message(other), "triangle 1: it lists its vertices in another order than in a"));
  other.faces[1] = {2, 1, 0};
  EXPECT_TRUE(test::contains(message(other), "triangle 1: it joins other vertices than in a"));
  other = mesh;
  other.loose_edges.clear();
  EXPECT_TRUE(test::contains(message(other), "0 loose edges, but a has 1"));
}

// Bug: a face that begins at another corner, or a rod from its other end, is taken for another one.
TEST_F(MeshFiles, FacesMayBeginAtAnyCorner) {
  const std::string five = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
  const MeshFile first = read_mesh(folder_.write("1.obj", five + "f 1 2 3\nf 1 2 3 4\nl 1 5\n"));
  const MeshFile second = read_mesh(folder_.write("2.obj", five + "f 3 1 2\nf 3 4 1 2\nl 5 1\n"));
  EXPECT_NO_THROW(require_same_mesh(first, "1", second, "2"));
  EXPECT_TRUE(has_topology_of(first, second));
  const MeshFile turned = read_mesh(folder_.write("3.obj", five + "f 1 2 3\nf 1 4 3 2\nl 1 5\n"));
  const std::string message = test::file_error("3", [&] { require_same_mesh(first, "1", turned, "3"); });
  EXPECT_TRUE(test::contains(message, "polygon 1: it lists its vertices in another order than in 1")) << message;
}

// Bug: a polygon that is convex in one frame and concave in the other has other triangles there, so the two are refused
// as frames of different meshes.
TEST_F(MeshFiles, PolygonsAreComparedNotTheirTriangles) {
  const std::string end = "f 1 2 3 4\n";
  const MeshFile convex = read_mesh(folder_.write("1.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n" + end));
  const MeshFile concave = read_mesh(folder_.write("2.obj", "v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\n" + end));
  const MeshFile other = read_mesh(folder_.write("3.obj", "v 0 0 0\nv .5 .5 0\nv 2 2 0\nv 0 2 0\n" + end));
  EXPECT_NE(convex.faces, other.faces);
  EXPECT_NO_THROW(require_same_mesh(convex, "1", concave, "2"));
  EXPECT_NO_THROW(require_same_mesh(convex, "1", other, "3"));
}

}  // namespace
}  // namespace tamis::io
