// The differences between the points of two features, projected on one axis.
#pragma once
#include "motion/pair_motion.hpp"
#include "numerics/select.hpp"

namespace tamis {

/// Smallest and largest projected difference.
template <class T>
struct Range {
  T low, high;
};

/// `e`, `f`, `d`: the projections of the vectors of PairMotion at one time.
template <PairKind kind, class T>
inline Range<T> range_of_differences([[maybe_unused]] const T& e, [[maybe_unused]] const T& f, const T& d) {
  [[maybe_unused]] const T zero(0);
  if constexpr (kind == PairKind::vertex_face)  // d, d - e, d - f
    return {d - max(zero, max(e, f)), d - min(zero, min(e, f))};
  else if constexpr (kind == PairKind::edge_edge)  // d + {0, f} - {0, e}
    return {d + min(zero, f) - max(zero, e), d + max(zero, f) - min(zero, e)};
  else if constexpr (kind == PairKind::vertex_edge)  // d, d - e
    return {d - max(zero, e), d - min(zero, e)};
  else if constexpr (kind == PairKind::vertex_vertex)
    return {d, d};
}

}  // namespace tamis
