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

}  // namespace tamis
