// The mesh against its definition read literally, on every kind of topology.
#include "tamis/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "search/topology/countable.hpp"
#include "search/topology/mean_edge.hpp"
#include "support/test_names.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

template <class Span>
std::vector<Index> sorted(const Span& items) {
  std::vector<Index> result(items.begin(), items.end());
  std::sort(result.begin(), result.end());
  return result;
}

class MeshOfScene : public testing::TestWithParam<Recipe> {
 protected:
  const Scene scene = GetParam().make(150, 3);
  const Mesh mesh = scene.mesh();
};

// Catches an edge listed once for each of its triangles: every contact would come twice.
TEST_P(MeshOfScene, EdgesAreUniqueAscendingAndComplete) {
  std::set<Edge> expected;
  const auto add = [&](Index a, Index b) {
    if (a != b) expected.insert({std::min(a, b), std::max(a, b)});
  };
  for (const Face& f : scene.faces)
    for (std::size_t k = 0; k < 3; ++k) add(f[k], f[(k + 1) % 3]);
  for (const Edge& e : scene.loose_edges) add(e[0], e[1]);
  EXPECT_TRUE(std::equal(mesh.edges().begin(), mesh.edges().end(), expected.begin(), expected.end()));
}

// Catches a mesh that keeps two triangles of an edge, as half-edge structures do.
TEST_P(MeshOfScene, EveryIncidentTriangleOfAnEdgeIsKnownOnce) {
  std::map<Edge, std::set<Index>> expected;
  for (std::size_t t = 0; t < scene.faces.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = scene.faces[t][k], b = scene.faces[t][(k + 1) % 3];
      expected[{std::min(a, b), std::max(a, b)}].insert(static_cast<Index>(t));
    }
  for (std::size_t e = 0; e < mesh.edges().size(); ++e)
    EXPECT_EQ(sorted(mesh.faces_of_edge(static_cast<Index>(e))), sorted(expected[mesh.edges()[e]])) << "edge " << e;
}

TEST_P(MeshOfScene, EveryIncidentTriangleOfAVertexIsKnownOnce) {
  std::vector<std::set<Index>> expected(scene.start.size());
  for (std::size_t t = 0; t < scene.faces.size(); ++t)
    for (Index v : scene.faces[t]) expected[static_cast<std::size_t>(v)].insert(static_cast<Index>(t));
  for (std::size_t v = 0; v < expected.size(); ++v)
    EXPECT_EQ(sorted(mesh.faces_of_vertex(static_cast<Index>(v))), sorted(expected[v])) << "vertex " << v;
}

TEST_P(MeshOfScene, EdgesOfAFaceFollowItsCorners) {
  for (std::size_t t = 0; t < scene.faces.size(); ++t) {
    const auto edges = mesh.edges_of_face(static_cast<Index>(t));
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = scene.faces[t][k], b = scene.faces[t][(k + 1) % 3];
      if (a == b)
        EXPECT_EQ(edges[k], -1);
      else
        EXPECT_EQ(mesh.edges()[static_cast<std::size_t>(edges[k])], (Edge{std::min(a, b), std::max(a, b)}));
    }
  }
}

TEST_P(MeshOfScene, PointsAreTheVerticesInUse) {
  std::set<Index> expected(scene.loose_points.begin(), scene.loose_points.end());
  for (const Face& f : scene.faces) expected.insert(f.begin(), f.end());
  for (const Edge& e : scene.loose_edges) expected.insert(e.begin(), e.end());
  EXPECT_TRUE(std::equal(mesh.points().begin(), mesh.points().end(), expected.begin(), expected.end()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeshOfScene, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

TEST(Mesh, VerticesThatNothingUsesTakeNoPart) {
  const Mesh mesh(10, {{7, 3, 5}}, {{1, 0}}, {9});
  EXPECT_EQ(sorted(mesh.points()), (std::vector<Index>{0, 1, 3, 5, 7, 9}));
  EXPECT_TRUE(mesh.faces_of_vertex(2).empty());
}

TEST(Mesh, RepeatedTrianglesAndLooseEdgesOfATriangleAreOneEdge) {
  const Mesh mesh(3, {{0, 1, 2}, {2, 1, 0}, {0, 1, 2}}, {{1, 0}, {0, 1}});
  EXPECT_EQ(mesh.edges().size(), 3u);
  for (Index e = 0; e < 3; ++e) EXPECT_EQ(mesh.faces_of_edge(e).size(), 3u);
}

TEST(Mesh, RefusesIndicesOutOfRangeAndNoFeatureAtAll) {
  EXPECT_THROW(Mesh(3, {{0, 1, 3}}), InvalidMesh);
  EXPECT_THROW(Mesh(3, {{0, 1, -1}}), InvalidMesh);
  EXPECT_THROW(Mesh(3, {{0, 1, 2}}, {{0, 3}}), InvalidMesh);
  EXPECT_THROW(Mesh(3, {{0, 1, 2}}, {}, {3}), InvalidMesh);
  EXPECT_THROW(Mesh(3, {}), InvalidMesh);
}

// Bug: the sentence of a mesh without features, whose advice does not help.
TEST(Mesh, NamesANumberOfVerticesThatIsNegative) {
  try {
    Mesh(-1, {});
    FAIL() << "there is no such mesh";
  } catch (const InvalidMesh& error) {
    EXPECT_NE(std::string(error.what()).find("the number of vertices is -1"), std::string::npos) << error.what();
  }
}

// Numbers of edges and offsets of rows were cut to 32 bits without a word.
TEST(MeshSize, ThatNoIndexCountsIsRefused) {
  const std::size_t most = 2147483647;
  EXPECT_NO_THROW(require_countable(most / 3, 0));
  EXPECT_THROW(require_countable(most / 3 + 1, 0), InvalidMesh);
  EXPECT_NO_THROW(require_countable(0, most));
  EXPECT_THROW(require_countable(1, most - 2), InvalidMesh);
  EXPECT_THROW(require_countable(0, most + 1), InvalidMesh);
  EXPECT_NO_THROW(require_countable_ends(most / 2));
  EXPECT_THROW(require_countable_ends(most / 2 + 1), InvalidMesh);
  EXPECT_NO_THROW(require_countable_pairs(most));
  EXPECT_THROW(require_countable_pairs(most + 1), Error);
}

// Of the largest meshes that are not refused: as many edges as fit, as faces' sides, as loose edges, and as both.
TEST(MeshSize, NumbersOfTheLargestMeshesDoNotOverflow) {
  const std::size_t most = 2147483647;
  for (const std::size_t faces : {most / 3, most / 4, std::size_t{0}}) {
    const std::size_t loose_edges = most - 3 * faces, edges = 3 * faces + loose_edges;
    EXPECT_NO_THROW(require_countable(faces, loose_edges));
    EXPECT_EQ(number_of(edges - 1), 2147483646);  // the last edge
    EXPECT_EQ(number_of(edges), 2147483647);      // the end of the last row
    EXPECT_THROW(require_countable(faces, loose_edges + 1), InvalidMesh);
  }
}

TEST(Mesh, FeaturesAreFoundByTheirVertices) {
  const Mesh mesh(8, {{2, 0, 1}, {1, 3, 2}, {2, 0, 1}, {4, 4, 5}}, {{7, 6}});
  for (std::size_t e = 0; e < mesh.edges().size(); ++e) {
    EXPECT_EQ(mesh.find_edge(mesh.edges()[e][0], mesh.edges()[e][1]), static_cast<Index>(e));
    EXPECT_EQ(mesh.find_edge(mesh.edges()[e][1], mesh.edges()[e][0]), static_cast<Index>(e));
  }
  EXPECT_EQ(mesh.find_face({2, 0, 1}), 0);  // the first of two
  EXPECT_EQ(mesh.find_face({1, 3, 2}), 1);
  EXPECT_EQ(mesh.find_face({4, 4, 5}), 3);
  EXPECT_EQ(mesh.find_face({0, 1, 2}), -1);  // another order is another face
  for (const Index none : {-1, 8, 1000}) EXPECT_EQ(mesh.find_face({none, 0, 1}), -1);
  EXPECT_EQ(mesh.find_edge(0, 3), -1);
  EXPECT_EQ(mesh.find_edge(4, 4), -1);
  EXPECT_EQ(mesh.find_edge(-1, 99), -1);
}

// Bug: of an infinite component std::hypot makes NaN, of three.
TEST(MeanEdge, IsFiniteAlways) {
  const Mesh mesh(3, {{0, 1, 2}});
  const double largest = std::numeric_limits<double>::max();
  const std::vector<Point> points{{-largest, 0, 0}, {largest, 1, 0}, {0, 0, largest}};
  EXPECT_EQ(mean_edge(mesh, points), largest);
}

}  // namespace
}  // namespace tamis::test
