// Principal axes of a symmetric 3 x 3 matrix.
#pragma once
#include "bounds/displacement_gradient.hpp"

namespace tamis::lab {

/// Orthonormal up to a few roundings, whatever the matrix. Jacobi's rotations; not certified to be eigenvectors.
std::array<Vec3<double>, 3> principal_axes(const SymmetricMatrix& matrix);

}  // namespace tamis::lab
