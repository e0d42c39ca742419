// Boxes around the vertices that a mesh uses.
#pragma once
#include <limits>
#include <span>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

struct Box {
  static constexpr double kFar = std::numeric_limits<double>::max();

  Point lowest{kFar, kFar, kFar};
  Point highest{-kFar, -kFar, -kFar};

  /// Also holds the vertices that the mesh uses, where `positions` has them.
  void add(const Mesh& mesh, std::span<const Point> positions);
};

/// The box around a step, which may be as large as doubles go.
struct Extent {
  Point middle{};
  double half = 0;  ///< half the longest side
};

Extent extent_of(const Mesh& mesh, std::span<const Point> start, std::span<const Point> end);

}  // namespace tamis::io
