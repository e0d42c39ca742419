// Pairs at rest: which are within their separation, and the NearPair of each.
#pragma once
#include "pair/distance/rest_distance.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

/// Some pairs' distances at rest and their separations, scaled by a power of two, and that power.
struct LoadedPoses {
  RestDistance<DoubleLanes> rest;
  DoubleLanes separation, scale;
};

template <PairKind kind>
inline LoadedPoses load_pose(const PackedVertex* vertices, const PairBuffer& pairs, int first,
                             const PairSeparation<double>& separation) {
  const auto at = load_vertices_at<kind>(vertices, false, pairs, first);
  constexpr SpanningVectors kVectors = spanning_vectors(kind);
  const auto e = difference(at, kVectors.e), f = difference(at, kVectors.f), d = difference(at, kVectors.d);
  const DoubleLanes size_e = largest_component(e), size_f = largest_component(f), size_d = largest_component(d);
  const DoubleLanes scale = scale_to_one(max(max(size_e, size_f), size_d));
  return {rest_distance<kind>(scale * e, scale * f, scale * d, scale * size_d + scale * size_e + scale * size_f),
          scale * load_separation<kind>(vertices, pairs, first, separation), scale};
}

/// Of the pairs that are not proven farther apart than their separation, writes those whose distance is sharp to
/// `near`, the others to `unsure`. So `near` also gets pairs beyond their separation by less than doubles can tell.
template <PairKind kind>
void find_within_at_rest(const MotionView& motion, const PairBuffer& in, PairBuffer& near, PairBuffer& unsure) {
  const auto append = [&](int first, unsigned lanes, PairBuffer& to) {
    store_corners(lanes, in, first, to, to.count);
    to.count += count_bits(lanes);
  };
  near.count = unsure.count = 0;
  for (int first = 0; first < in.count; first += kFloatLanes) {
    unsigned far = 0, sharp = 0;
    for (int lane = 0; lane < kFloatLanes; lane += kDoubleLanes) {
      const LoadedPoses poses = load_pose<kind>(motion.vertices, in, first + lane, motion.separation);
      far |= bits(poses.rest.low > poses.separation) << lane;
      sharp |= bits(poses.rest.is_sharp()) << lane;
    }
    const unsigned left = lanes_in_use(in, first, kFloatLanes) & ~far;
    append(first, left & sharp, near);
    append(first, left & ~sharp, unsure);
  }
}

/// Writes the NearPair of every pair of the buffer, in its order.
template <PairKind kind>
void measure(const PackedVertex* vertices, const PairBuffer& in, NearPair* out) {
  for (int first = 0; first < in.count; first += kDoubleLanes) {
    const auto [rest, no_separation, scale] = load_pose<kind>(vertices, in, first, {});
    const auto& [u, v, gap] = rest.closest;
    const Vec3<DoubleLanes> direction = near_direction<kind>(unit_vector(rest.direction));
    const DoubleLanes distance = Masked<DoubleLanes>::nan_where(!rest.is_sharp(), rest.distance / scale);
    const DoubleLanes fields[] = {distance, u, v, direction.x, direction.y, direction.z};
    double f[6][kDoubleLanes];
    for (int k = 0; k < 6; ++k) fields[k].store_unaligned(f[k]);
    for_each_bit(lanes_in_use(in, first), [&](int i) {
      const auto corner = [&](std::size_t c) { return c < vertex_count(kind) ? in.corner[c][first + i] : -1; };
      out[first + i] = {
          kind, {corner(0), corner(1), corner(2), corner(3)}, f[0][i], f[1][i], f[2][i], {f[3][i], f[4][i], f[5][i]}};
    });
  }
}

}  // namespace tamis::TAMIS_ISA
