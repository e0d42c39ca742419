// Principal axes of a symmetric 3 x 3 matrix.
#pragma once
#include <array>

#include "numerics/vec.hpp"

namespace tamis {

struct SymmetricMatrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  void add_square(const Vec3<double>& v, double weight = 1);
  SymmetricMatrix& operator+=(const SymmetricMatrix& other);
};

/// Orthonormal up to a few roundings, whatever the matrix. Jacobi's rotations; not certified to be eigenvectors.
std::array<Vec3<double>, 3> principal_axes(const SymmetricMatrix& matrix);

}  // namespace tamis
