// Closest points of two features at rest: contact weights where the crossing's are not at hand, and distances.
#pragma once
#include <array>

#include "numerics/vec.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// u, v as in Contact; `gap`: from the closest point of the face (the first edge; the edge or second vertex of a first
/// vertex) to the other's.
struct ClosestPoints {
  double u, v;
  Vec3<double> gap;
};

/// `e`, `f`, `d` as in PairMotion at one time. Any degenerate feature is legal. Not certified.
ClosestPoints closest_points(PairKind kind, const Vec3<double>& e, const Vec3<double>& f, const Vec3<double>& d);

}  // namespace tamis
