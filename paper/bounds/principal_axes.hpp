// Principal axes of a symmetric 3 x 3 matrix.
#pragma once
#include "search/bounds/displacement_gradient.hpp"

namespace tamis::lab {

/// By Jacobi's rotations. Orthonormal up to a few roundings for every matrix; not certified to be eigenvectors.
std::array<Vec3<double>, 3> principal_axes(const SymmetricMatrix& matrix);

}  // namespace tamis::lab
