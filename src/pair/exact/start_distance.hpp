// The distance at t=0 compared with a separation, decided exactly. Rounding must not stop a step that may go a little.
#pragma once
#include "pair/exact/moving_polygon.hpp"

namespace tamis {

/// True if the origin is within the separation of the polygon. Decided exactly.
/// REQUIRES: the separation is finite, >= 0 and a multiple of the polygon's unit.
bool is_within(const Polygon<Integer>& polygon, double separation);

/// True if the features are within the separation of each other at t=0. Decided exactly, by estimates where all signs
/// are plain. REQUIRES: finite coordinates, a finite separation >= 0.
bool starts_within(PairKind kind, const PairPoints& points, double separation);

/// 0 if at t=0 the features are within `separation` of each other. Else a time > 0 (unless it underflows) before which
/// they are farther: their distance less `separation`, over a bound of their relative speed. Infinite if neither moves
/// against the other. The case is decided exactly. REQUIRES: finite coordinates, a finite separation >= 0.
double apart_from_start(PairKind kind, const PairPoints& points, double separation);

}  // namespace tamis
