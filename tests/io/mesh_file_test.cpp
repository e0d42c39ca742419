#include "io/mesh/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/mesh/mesh_formats.hpp"
#include "io/messages.hpp"
#include "io/ply_builder.hpp"
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
  EXPECT_TRUE(test::contains(error_of(folder_.write("a.stl", "solid cube\n")), "not " + mesh_format_names()));
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
  EXPECT_TRUE(test::contains(message(other), "triangle 1"));
  other = mesh;
  other.loose_edges.clear();
  EXPECT_TRUE(test::contains(message(other), "0 loose edges, but a has 1"));
}

}  // namespace
}  // namespace tamis::io
