// Places at which two bodies are near each other.
#include "integrations/near_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace tamis::adapters {
namespace {

/// A box around the origin.
Shape box(const Point& half) {
  std::vector<Point> points;
  for (const double x : {-half[0], half[0]})
    for (const double y : {-half[1], half[1]})
      for (const double z : {-half[2], half[2]}) points.push_back({x, y, z});
  return {Mesh(8, {{0, 1, 3},
                   {0, 3, 2},
                   {4, 7, 5},
                   {4, 6, 7},
                   {0, 5, 1},
                   {0, 4, 5},
                   {2, 3, 7},
                   {2, 7, 6},
                   {0, 2, 6},
                   {0, 6, 4},
                   {1, 5, 7},
                   {1, 7, 3}}),
          points};
}

/// If it were more, each corner of a box would be a contact with five faces of the box below; if none, with no face.
TEST(NearFeatures, AreToldByOneOfTheFacesAtTheirPoint) {
  const Shape shape = box({1, 2, 3});
  const Mesh& mesh = shape.mesh();
  for (const double second : {0.0, 0.25})  // at a vertex; on an edge
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
      const auto around = mesh.faces_of_vertex(vertex);
      const Face& first = mesh.faces()[static_cast<std::size_t>(around[0])];
      const Index other = first[first[0] == vertex ? 1 : 0];
      int told = 0;
      for (const Index number : around) {
        const Face& face = mesh.faces()[static_cast<std::size_t>(number)];
        std::array<double, 3> weights{};
        for (std::size_t i = 0; i < 3; ++i) weights[i] = face[i] == vertex ? 1 - second : face[i] == other ? second : 0;
        if (second > 0 && std::ranges::find(face, other) == face.end()) continue;
        const NearFeature feature(shape, face, weights);
        EXPECT_EQ(feature.is_vertex(), second == 0);
        told += !feature.is_repeated();
      }
      EXPECT_EQ(told, 1) << vertex;
    }
}

TEST(NearContacts, KeepTheCornersAndTheNearest) {
  std::vector<NearContact> contacts;
  for (int x = 0; x < 5; ++x)
    for (int z = 0; z < 5; ++z) {
      const Point place{static_cast<double>(x), 0, static_cast<double>(z)};
      contacts.push_back({{0, 1}, {plus(place, {0, x == 2 && z == 1 ? 0.5 : 1.0, 0}), place}, {0, 1, 0}});
    }
  std::vector<std::array<int, 2>> kept;
  for (const NearContact& contact : essential(contacts))
    kept.push_back({static_cast<int>(contact.points[1][0]), static_cast<int>(contact.points[1][2])});
  EXPECT_EQ(std::ranges::count(kept, std::array{2, 1}), 1);
  for (const int x : {0, 4})
    for (const int z : {0, 4}) EXPECT_EQ(std::ranges::count(kept, std::array{x, z}), 1) << x << z;
  EXPECT_LE(kept.size(), 9U);
  contacts[12].normal = {1, 0, 0};
  EXPECT_EQ(essential(contacts).size(), kept.size() + 1);
}

}  // namespace
}  // namespace tamis::adapters
