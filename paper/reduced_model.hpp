// A model whose vertices move in a subspace: x = X + U q.
#pragma once
#include <cstddef>
#include <vector>

#include "tamis/step.hpp"

namespace tamis::lab {

/// The subspace of a reduced-coordinate simulation, for high-level culling. Steps need not give q: it is computed from
/// the positions, and their distance from X + U q is bounded. Positions that are not of the model are legal; then
/// nothing is culled. Sizes that do not fit the mesh, and entries that are not finite, make the detector throw
/// InvalidOptions.
struct ReducedModel {
  std::vector<Point> rest;    ///< X: one row a vertex of the mesh
  Index modes = 0;            ///< columns of U, r >= 1; they may be dependent or zero
  std::vector<double> basis;  ///< U, 3 n x r, row-major: of vertex v and axis a, row 3 v + a

  /// U's row of a vertex and an axis: `modes` numbers.
  const double* row(Index vertex, Index axis) const {
    return basis.data() + (std::size_t{3} * static_cast<std::size_t>(vertex) + static_cast<std::size_t>(axis)) *
                              static_cast<std::size_t>(modes);
  }
};

}  // namespace tamis::lab
