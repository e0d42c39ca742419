// Points as vectors in doubles; results are rounded.
#pragma once
#include "tamis/positions.hpp"

namespace tamis {

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

}  // namespace tamis
