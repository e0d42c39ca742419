// Do triangles of one pose pass through each other? Naive on purpose, and independent of the library.
#pragma once
#include <optional>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::test {

struct Crossing {
  Edge edge;
  Face face;
};

/// An edge that passes through a triangle without a common vertex; none if there is no such pair. Mere touching, and
/// edges within a triangle's plane, are not looked for.
std::optional<Crossing> find_crossing(const std::vector<Point>& positions, const std::vector<Face>& faces);

}  // namespace tamis::test
