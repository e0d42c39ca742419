// What hangs together in a mesh.
#include "tamis/components.hpp"

#include <gtest/gtest.h>

namespace tamis {
namespace {

// Bugs: loose edges that connect nothing, numbers in the order of the search's roots, vertices without use that count.
TEST(Components, AreConnectedByFacesAndEdgesAndNumberedByTheirFirstVertices) {
  const std::vector<Face> faces{{7, 8, 9}, {1, 2, 3}, {2, 3, 4}};
  const std::vector<Edge> rods{{9, 0}};
  const std::vector<Index> points{5};
  const Components components = components_of(Mesh(10, faces, rods, points));
  EXPECT_EQ(components.count, 3);
  EXPECT_EQ(components.of_vertex, (std::vector<Index>{0, 1, 1, 1, 1, 2, -1, 0, 0, 0}));
}

}  // namespace
}  // namespace tamis
