// The Minkowski difference of the two features of a pair is the convex hull of these: the distance of the features is
// its distance from zero, and the fastest of its corners bounds the speed of any point of one against any of the other.
#pragma once
#include <array>

#include "motion/pair_motion.hpp"

namespace tamis {

template <PairKind kind, class T>
inline auto difference_corners(const PairMotion<T>& m) {
  if constexpr (kind == PairKind::vertex_face)
    return std::array{m.d, m.d - m.e, m.d - m.f};
  else if constexpr (kind == PairKind::edge_edge)
    return std::array{m.d, m.d - m.e, m.d + m.f, m.d + m.f - m.e};
  else if constexpr (kind == PairKind::vertex_edge)
    return std::array{m.d, m.d - m.e};
  else
    return std::array{m.d};
}

}  // namespace tamis
