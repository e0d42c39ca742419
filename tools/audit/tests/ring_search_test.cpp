#include "audit/ring_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>

#include "audit/tests/recorded.hpp"
#include "tamis/error.hpp"

namespace tamis::audit {
namespace {

constexpr int kSide = 6;

/// A sheet, and a triangle that hangs on nothing.
Mesh sheet_and_triangle() {
  std::vector<Face> faces = test::sheet_faces(kSide);
  const Index vertices = (kSide + 1) * (kSide + 1);
  faces.push_back({vertices, vertices + 1, vertices + 2});
  return Mesh(vertices + 3, std::move(faces));
}

/// Breadth-first without a limit, from every vertex anew; -1 if there is no way.
Index rings_naively(const Mesh& mesh, std::span<const Index> first, std::span<const Index> second) {
  std::deque<std::pair<Index, Index>> waiting;
  std::set<Index> seen;
  for (const Index v : first) waiting.emplace_back(v, 0), seen.insert(v);
  for (; !waiting.empty(); waiting.pop_front()) {
    const auto [vertex, rings] = waiting.front();
    if (std::find(second.begin(), second.end(), vertex) != second.end()) return rings;
    for (const Edge& e : mesh.edges())
      for (const auto& [from, to] : {std::pair(e[0], e[1]), std::pair(e[1], e[0])})
        if (from == vertex && seen.insert(to).second) waiting.emplace_back(to, rings + 1);
  }
  return kNotConnected;
}

// Bug: a search that is kept from one pair to the next gives the next one's first feature the distances of the last.
TEST(RingSearch, IsThatOfASearchForEachPairAnew) {
  const AuditedMesh mesh(sheet_and_triangle());
  constexpr Index kLimit = 4;
  RingSearch search(mesh, kLimit);
  const auto edges = mesh.mesh().edges();
  for (std::size_t i = 0; i < edges.size(); i += 7)
    for (std::size_t j = 0; j < edges.size(); j += 5) {
      const Index exact = rings_naively(mesh.mesh(), edges[i], edges[j]);
      EXPECT_EQ(search.between(edges[i], edges[j]), std::min(exact, kLimit + 1)) << i << " " << j;
    }
}

TEST(RingSearch, CountsEdgesFromAVertexToAFace) {
  const AuditedMesh mesh(sheet_and_triangle());
  RingSearch search(mesh, 10);
  const std::array<Index, 1> corner{0}, alone{(kSide + 1) * (kSide + 1)};
  EXPECT_EQ(search.between(corner, Face{0, 1, 8}), 0);
  EXPECT_EQ(search.between(corner, Face{1, 2, 9}), 1);
  EXPECT_EQ(search.between(corner, Face{3, 4, 11}), 3);
  EXPECT_EQ(search.between(alone, Face{0, 1, 8}), kNotConnected);
}

TEST(AuditedMesh, ObjectsAreWhatIsConnectedUnlessTheyAreNamed) {
  const Mesh mesh = sheet_and_triangle();
  const AuditedMesh by_itself(mesh);
  EXPECT_EQ(by_itself.object_of(3), 0);
  EXPECT_EQ(by_itself.object_of(mesh.vertex_count() - 1), 1);
  EXPECT_EQ(by_itself.objects().name_of(1), "1");
  std::vector<Index> of_vertex(static_cast<std::size_t>(mesh.vertex_count()), 1);
  of_vertex[3] = 0;
  const AuditedMesh named(mesh, {of_vertex, {"hand", "cloth"}});
  EXPECT_EQ(named.objects().name_of(named.object_of(3)), "hand");
  EXPECT_TRUE(named.are_connected(3, 4)) << "names are no topology";
  EXPECT_THROW(AuditedMesh(mesh, {{0, 1}, {}}), InvalidMesh);
  of_vertex[0] = -2;
  EXPECT_THROW(AuditedMesh(mesh, {of_vertex, {}}), InvalidMesh);
}

}  // namespace
}  // namespace tamis::audit
