// Pairs at rest, one a lane: only the vertices' positions at t=0 are read.
#pragma once
#include "distance/rest_distance.hpp"
#include "kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

/// Some pairs' distances at rest and their separations, scaled by a power of two, and that power.
struct LoadedPoses {
  RestDistance<DoubleLanes> rest;
  DoubleLanes separation, scale;
};

template <PairKind kind>
inline LoadedPoses load_pose(const PackedVertex* vertices, const PairBuffer& pairs, int first,
                             const PairSeparation& separation) {
  const auto at = load_vertices_at<kind>(vertices, false, pairs, first);
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = difference(at, kVectors.e), f = difference(at, kVectors.f), d = difference(at, kVectors.d);
  const DoubleLanes size_e = largest_component(e), size_f = largest_component(f), size_d = largest_component(d);
  const DoubleLanes scale = scale_to_one(max(max(size_e, size_f), size_d));
  return {rest_distance<kind>(scale * e, scale * f, scale * d, scale * size_d + scale * size_e + scale * size_f),
          scale * load_separation<kind>(vertices, pairs, first, separation), scale};
}

}  // namespace tamis::TAMIS_ISA
