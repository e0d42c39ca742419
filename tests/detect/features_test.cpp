// Features by number. Would catch: an edge or a face of another contact, a face found in another winding.
#include <gtest/gtest.h>

#include "scenes/scene_list.hpp"
#include "tamis/detector.hpp"

namespace tamis {
namespace {

TEST(FeaturePairs, AreThePlacesOfAContactsFeatures) {
  const scenes::Scene scene = scenes::scene_by_name("folded-cloth", 800, 3);
  Detector detector(scene.mesh());
  const Mesh& mesh = detector.mesh();
  const auto& contacts = detector.contacts(scene.step());
  ASSERT_FALSE(contacts.empty());
  for (const auto& c : contacts) {
    const auto& v = c.vertices;
    const FeaturePair pair = features_of(mesh, c.kind, v);
    const auto second = static_cast<std::size_t>(pair.second);
    if (c.kind == PairKind::vertex_face) {
      EXPECT_EQ(pair.first, v[0]);
      EXPECT_EQ(mesh.faces()[second], (Face{v[1], v[2], v[3]}));
    } else {
      EXPECT_EQ(mesh.edges()[static_cast<std::size_t>(pair.first)], (Edge{v[0], v[1]}));
      EXPECT_EQ(mesh.edges()[second], (Edge{v[2], v[3]}));
    }
  }
}

TEST(FeaturePairs, OfLoosePointsAreEdgesAndVertices) {
  const Mesh mesh(5, {}, {{3, 2}, {2, 1}}, {0, 4});
  const FeaturePair edge = features_of(mesh, PairKind::vertex_edge, {0, 2, 3, -1});
  EXPECT_EQ(edge.first, 0);
  EXPECT_EQ(edge.second, 1);
  const FeaturePair points = features_of(mesh, PairKind::vertex_vertex, {0, 4, -1, -1});
  EXPECT_EQ(points.first, 0);
  EXPECT_EQ(points.second, 4);
  EXPECT_EQ(features_of(mesh, PairKind::vertex_face, {0, 1, 2, 3}).second, -1);
}

}  // namespace
}  // namespace tamis
