// The box around a step.
#pragma once
#include <span>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// The box around the vertices that a mesh uses, at both ends of the step.
struct Extent {
  Point middle{};
  double half = 0;  ///< half the longest side
};

Extent extent_of(const Mesh& mesh, std::span<const Point> start, std::span<const Point> end);

}  // namespace tamis::io
