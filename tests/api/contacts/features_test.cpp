// Numbers of features, and points on them by weights. Would catch: an edge or a face of another contact, a face found
// although its winding differs.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "scenes/scene_list.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

TEST(FeaturesOf, AreThePlacesOfAContactsFeatures) {
  const scenes::Scene scene = scenes::scene_by_name("folded-cloth", 800, 3);
  Detector detector(scene.mesh());
  const Mesh& mesh = detector.mesh();
  const auto& contacts = detector.contacts(scene.step());
  ASSERT_FALSE(contacts.empty());
  for (const auto& c : contacts) {
    const auto& v = c.vertices;
    const auto [first, second_place] = features_of(mesh, c.kind, v);
    const auto second = static_cast<std::size_t>(second_place);
    if (c.kind == PairKind::vertex_face) {
      EXPECT_EQ(first, v[0]);
      EXPECT_EQ(mesh.faces()[second], (Face{v[1], v[2], v[3]}));
    } else {
      EXPECT_EQ(mesh.edges()[static_cast<std::size_t>(first)], (Edge{v[0], v[1]}));
      EXPECT_EQ(mesh.edges()[second], (Edge{v[2], v[3]}));
    }
  }
}

TEST(FeaturesOf, OfLoosePointsAreEdgesAndVertices) {
  const Mesh mesh(5, {}, {{3, 2}, {2, 1}}, {0, 4});
  using Places = std::array<Index, 2>;
  EXPECT_EQ(features_of(mesh, PairKind::vertex_edge, {0, 2, 3, -1}), (Places{0, 1}));
  EXPECT_EQ(features_of(mesh, PairKind::vertex_vertex, {0, 4, -1, -1}), (Places{0, 4}));
}

/// The message that refuses a pair which the mesh does not have; empty if the pair is found.
std::string refusal(const Mesh& mesh, PairKind kind, const std::array<Index, 4>& vertices) {
  try {
    (void)features_of(mesh, kind, vertices);
    return "";
  } catch (const InvalidMesh& error) {
    return error.what();
  }
}

// Bugs: vertex numbers that the mesh lacks were returned as features; -1 is a valid row of an array in many languages.
TEST(FeaturesOf, OfAnotherMeshAreRefusedByName) {
  const Mesh mesh(5, {{0, 1, 2}, {3, 1, 2}}, {{3, 4}});
  const std::string advice = ": give a pair of this mesh, its vertices as in Contact";
  EXPECT_EQ(refusal(mesh, PairKind::vertex_face, {3, 0, 1, 2}), "");
  EXPECT_EQ(refusal(mesh, PairKind::vertex_face, {5, 0, 1, 2}),
            "the mesh has 5 vertices and none with the number 5" + advice);
  EXPECT_EQ(refusal(mesh, PairKind::vertex_vertex, {0, -1, -1, -1}),
            "the mesh has 5 vertices and none with the number -1" + advice);
  EXPECT_EQ(refusal(mesh, PairKind::vertex_face, {4, 0, 1, 3}),
            "the mesh has no face of the vertices 0, 1, 3" + advice);
  EXPECT_EQ(refusal(mesh, PairKind::vertex_face, {4, 2, 1, 0}),
            "the mesh has no face of the vertices 2, 1, 0 in this order, but 0, 1, 2: give them so");
  EXPECT_EQ(refusal(mesh, PairKind::vertex_face, {4, 1, 2, 3}),
            "the mesh has no face of the vertices 1, 2, 3 in this order, but 3, 1, 2: give them so");
  EXPECT_EQ(refusal(mesh, PairKind::edge_edge, {0, 1, 2, 4}),
            "the mesh has no edge between the vertices 2 and 4" + advice);
  EXPECT_EQ(refusal(mesh, PairKind::edge_edge, {1, 0, 4, 3}), "");
  EXPECT_EQ(refusal(mesh, static_cast<PairKind>(9), {1, 0, 4, 3}),
            "unknown kind number 9: use one of the enumeration's names");
}

TEST(SignedWeights, GiveTheVectorBetweenBothPoints) {
  using Weights = std::array<double, 4>;
  EXPECT_EQ(weights_of(PairKind::vertex_face, 0.25, 0.5), (Weights{1, -0.25, -0.25, -0.5}));
  EXPECT_EQ(weights_of(PairKind::edge_edge, 0.25, 0.5), (Weights{0.75, 0.25, -0.5, -0.5}));
  EXPECT_EQ(weights_of(PairKind::vertex_edge, 0.25, 0), (Weights{1, -0.75, -0.25, 0}));
  EXPECT_EQ(weights_of(PairKind::vertex_vertex, 0, 0), (Weights{1, -1, 0, 0}));
  EXPECT_THROW((void)weights_of(static_cast<PairKind>(kPairKinds), 0, 0), Error);
}

// Bug: a weight of another vertex, or with the wrong sign.
TEST(SignedWeights, OfNearPairsGiveTheirDistanceAndDirection) {
  std::mt19937 random(3);
  std::vector<Point> at(40);
  for (Point& p : at)
    for (double& x : p) x = std::uniform_real_distribution(0.0, 1.0)(random);
  std::vector<Face> faces;
  std::vector<Edge> rods;
  for (Index i = 0; i < 15; i += 3) faces.push_back({i, i + 1, i + 2});
  for (Index i = 15; i < 30; i += 2) rods.push_back({i, i + 1});
  Detector detector(Mesh(40, faces, rods, {31, 32, 33, 34, 35, 36, 37, 38, 39}));
  std::array<int, 4> counts{};
  for (const NearPair& pair : detector.pairs_within(at, 0.5)) {
    ++counts[static_cast<std::size_t>(pair.kind)];
    const std::array<double, 4> weights = weights_of(pair.kind, pair.u, pair.v);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double between = 0;
      for (std::size_t i = 0; i < 4; ++i)
        if (pair.vertices[i] >= 0) between += weights[i] * at[static_cast<std::size_t>(pair.vertices[i])][axis];
      ASSERT_NEAR(between, pair.distance * pair.direction[axis], 1e-12);
    }
  }
  for (const int count : counts) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace tamis
