// What is said of a mesh at rest: which features are near each other, and which pass through each other.
#pragma once
#include <array>

#include "tamis/contact.hpp"

namespace tamis {

/// A pair of features that are near each other.
struct NearPair {
  PairKind kind;
  std::array<Index, 4> vertices;  ///< as in Contact
  /// Between the closed features, in the unit of the positions; off by at most 2^-41 of the largest |component| of the
  /// differences between the pair's vertices, and below the smallest normal double by half the smallest double
  /// (2^-1075) more, as doubles lie no closer there: proven.
  double distance;
  /// Weights of two closest points, as in Contact. Of parallel edges one such pair of points. weights_of is 0 for just
  /// the vertices that have no share in these points: so of a face it leaves one vertex for a corner, two for a border,
  /// three for the inside.
  double u, v;
  /// Unit vector from the second feature's closest point to the first's. Where they touch: along the normal if that is
  /// inside a face or two edges, else zero.
  Point direction;
};

/// An edge that passes through a triangle, or touches it, without a common vertex.
struct Intersection {
  Edge edge;  ///< vertex indices, ascending
  Face face;  ///< vertex indices, in the mesh's order
  /// The first common point along the edge, counted from edge[0]: its parameter on the edge lies in [s_lower, s_upper],
  /// and it is (1-u-v) f0 + u f1 + v f2, rounded.
  double s_lower, s_upper;
  double u, v;
};

}  // namespace tamis
