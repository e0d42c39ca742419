// How many edges lie between features: by hand, and against the distances of all vertices (Floyd, Warshall).
#include "search/topology/rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/random.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

using Features = std::vector<std::vector<Index>>;

/// Edges on the shortest way between any two vertices.
std::vector<std::vector<int>> distances_in(const Mesh& mesh) {
  constexpr int kNoWay = 1 << 20;
  const std::size_t n = at(mesh.vertex_count());
  std::vector<std::vector<int>> d(n, std::vector<int>(n, kNoWay));
  for (std::size_t i = 0; i < n; ++i) d[i][i] = 0;
  for (const auto& [a, b] : mesh.edges()) d[at(a)][at(b)] = d[at(b)][at(a)] = 1;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  return d;
}

Features features_of(const Mesh& mesh) {
  Features all;
  for (const Index v : mesh.points()) all.push_back({v});
  for (const Edge& e : mesh.edges()) all.push_back({e[0], e[1]});
  for (const Face& f : mesh.faces()) all.push_back({f[0], f[1], f[2]});
  return all;
}

// Bugs: a ring counted once too often or too seldom, a way that ends at the border of a component, a way through a rod
// that is not taken, a vertex that is met again.
TEST(Rings, AreThoseOfShortestWays) {
  scenes::Random random(5);
  for (int round = 0; round < 12; ++round) {
    const Index vertices = 6 + random.below(14);
    std::vector<Face> faces;
    std::vector<Edge> rods;
    for (Index i = 0; i < vertices / 2; ++i)
      faces.push_back({random.below(vertices), random.below(vertices), random.below(vertices)});
    for (Index i = 0; i < vertices / 4; ++i) rods.push_back({random.below(vertices), random.below(vertices)});
    const Mesh mesh(vertices, faces, rods, {0});
    const auto distances = distances_in(mesh);
    const Features features = features_of(mesh);
    for (int rings = 1; rings <= 5; ++rings) {
      const Rings asked(mesh, rings);
      for (const auto& a : features)
        for (const auto& b : features) {
          int least = 1 << 20;
          for (const Index v : a)
            for (const Index w : b) least = std::min(least, distances[at(v)][at(w)]);
          if (least == 0) continue;  // no pair
          EXPECT_EQ(asked.are_neighbours(a, b), least < rings);
        }
    }
  }
}

// Bugs: a number of rings that is beyond what the mesh has, or a search of them that does not end.
TEST(Rings, OfAnyNumberLeaveOutAllThatIsConnected) {
  const Mesh mesh(5, {{0, 1, 2}}, {{2, 3}}, {4});
  const Rings rings(mesh, 2147483647);
  EXPECT_TRUE(rings.are_neighbours(std::vector<Index>{0}, std::vector<Index>{3}));
  EXPECT_FALSE(rings.are_neighbours(std::vector<Index>{0}, std::vector<Index>{4}));
  EXPECT_FALSE(rings.are_neighbours(std::vector<Index>{4}, std::vector<Index>{0, 1, 2}));
}

}  // namespace
}  // namespace tamis
