// Answers about a mesh in one pose: pairs of near features, and edges that pass through triangles.
#pragma once
#include <array>

#include "tamis/contact.hpp"

namespace tamis {

/// A pair of features that are near each other.
struct NearPair {
  PairKind kind;                  ///< which features
  std::array<Index, 4> vertices;  ///< as in Contact
  /// The distance between the closed features, in the unit of the positions. Proven: off by at most 2^-41 of the
  /// largest |component| of the differences between the pair's vertices. Below the smallest normal double it is off by
  /// at most 2^-1075 more: half the smallest double.
  double distance;
  /// Weight of two closest points, as in Contact. Parallel edges have many such points, and these are two of them.
  /// weights_of is exactly 0 for the vertices that have no share in these points. Of a face one vertex has a share if
  /// the point is a corner, two if it is on the border, three if it is inside.
  double u;
  double v;  ///< second weight, as in Contact
  /// Unit vector from the second feature's closest point to the first's. If they touch, it is along the normal where
  /// the common point is inside a face or inside two edges, else zero.
  Point direction;
};

/// An edge that passes through a triangle, or touches it, and shares no vertex with it.
struct Intersection {
  Edge edge;  ///< vertex indices, ascending
  Face face;  ///< vertex indices, in the mesh's order
  /// The first common point along the edge, from edge[0] on. Its parameter on the edge lies in [s_lower, s_upper].
  double s_lower;
  double s_upper;  ///< upper bound of that parameter
  double u;        ///< weight: that point is (1-u-v) f0 + u f1 + v f2, rounded
  double v;        ///< second weight
};

}  // namespace tamis
