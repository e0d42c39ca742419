// The Minkowski difference of the two features of a pair is the convex hull of these: the distance of the features is
// its distance from zero, and the fastest of its corners bounds the speed of any point of one against any of the other.
#pragma once
#include <array>

#include "motion/pair_motion.hpp"

namespace tamis {

/// `V`: vectors at one time, or moving ones; named as in PairMotion.
template <PairKind kind, class V>
inline auto difference_corners([[maybe_unused]] const V& e, [[maybe_unused]] const V& f, const V& d) {
  if constexpr (kind == PairKind::vertex_face)
    return std::array{d, d - e, d - f};
  else if constexpr (kind == PairKind::edge_edge)
    return std::array{d, d - e, d + f, d + f - e};
  else if constexpr (kind == PairKind::vertex_edge)
    return std::array{d, d - e};
  else if constexpr (kind == PairKind::vertex_vertex)
    return std::array{d};
}

template <PairKind kind, class T>
inline auto difference_corners(const PairMotion<T>& m) {
  return difference_corners<kind>(m.e, m.f, m.d);
}

/// Of the fastest corner: convex combinations of the corners' velocities are those of all pairs of points.
template <PairKind kind, class T>
inline T squared_speed(const PairMotion<T>& m) {
  T square(0);
  for (const auto& corner : difference_corners<kind>(m)) {
    const Vec3<T> velocity = corner.at1 - corner.at0;
    square = max(square, dot(velocity, velocity));
  }
  return square;
}

}  // namespace tamis
