// Nearest points of two features at one time.
#pragma once
#include <Eigen/Core>

#include "tamis/contact.hpp"

namespace tamis::simulation {

/// One column a vertex, in the order of Contact.
using Corners = Eigen::Matrix<double, 3, 4>;

/// Weights w of the corners such that `corners * w` leads from the nearest point of the second feature to that of the
/// first (Ericson 2005, 5.1.5 and 5.1.9).
Eigen::Vector4d nearest_weights(PairKind kind, const Corners& corners);

}  // namespace tamis::simulation
