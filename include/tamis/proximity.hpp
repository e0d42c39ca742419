// What is said of a mesh at rest: which features are near each other, and which pass through each other.
#pragma once
#include <array>
#include <cstdint>

#include "tamis/contact.hpp"

namespace tamis {

/// A pair of features that are near each other.
struct NearPair {
  PairKind kind;
  /// Bit i is set if vertices[i] has a share in the closest points: which corners, borders or insides they lie on. vf:
  /// bit 0, and of bits 1 to 3 one for a corner of the face, two for a border, three for its inside. ee: of bits 0, 1
  /// and of bits 2, 3 one for an end, two for the inside of the edge. ve and vv likewise.
  std::uint8_t corners;
  std::array<Index, 4> vertices;  ///< as in Contact
  /// Between the closed features, in the unit of the positions; off by at most 2^-41 of the largest |component| of the
  /// differences between the pair's vertices, and below the smallest normal double by half the smallest double
  /// (2^-1075) more, as doubles lie no closer there: proven.
  double distance;
  /// Weights of two closest points, as in Contact. Of parallel edges one such pair of points.
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
