// Tests whether a point is finite.
#pragma once
#include "numbers/platform.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// x - x is 0 for finite x, NaN otherwise. So one test serves all three.
inline bool is_finite(const double* p) { return p[0] - p[0] + (p[1] - p[1]) + (p[2] - p[2]) == 0; }
inline bool is_finite(const Point& p) { return is_finite(p.data()); }

}  // namespace tamis
