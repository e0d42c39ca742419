// What NearPair says of the closest points of two features, in doubles or in lanes.
#pragma once
#include <array>

#include "filters/filter.hpp"
#include "motion/pair_kinds.hpp"
#include "numerics/select.hpp"
#include "numerics/vec.hpp"

namespace tamis {

template <class T>
struct NearFacts {
  std::array<Mask<T>, 4> corners;  ///< as the bits of NearPair::corners
  Vec3<T> direction;               ///< as in NearPair
};

/// `u`, `v` as in ClosestPointsOf; `unit`: along its gap, zero or NaN where nothing tells the direction.
template <PairKind kind, class T>
inline NearFacts<T> near_facts(const T& u, const T& v, const Vec3<T>& unit) {
  const T zero(0), one(1);
  const Mask<T> all(true), none(false);
  // Edges have the gap from the first to the second. No component is -0.
  const T sign(kind == PairKind::edge_edge ? -1 : 1);
  const auto is_known = unit.x == unit.x;  // NOLINT(misc-redundant-expression): NaN where it is not
  const auto component = [&](const T& x) { return select(is_known, sign * x, zero) + zero; };
  const Vec3<T> direction{component(unit.x), component(unit.y), component(unit.z)};
  if constexpr (kind == PairKind::vertex_face)
    return {{all, u + v<one, u> zero, v > zero}, direction};
  else if constexpr (kind == PairKind::edge_edge)
    return {{u<one, u> zero, v<one, v> zero}, direction};
  else if constexpr (kind == PairKind::vertex_edge)
    return {{all, u<one, u> zero, none}, direction};
  else if constexpr (kind == PairKind::vertex_vertex)
    return {{all, all, none, none}, direction};
}

}  // namespace tamis
