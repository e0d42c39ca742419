// The roots of an integer polynomial in [0,1], separated by Descartes' rule, bisection (Collins, Akritas 1976) and
// Newton's method (Sagraloff, Mehlhorn 2016).
#pragma once
#include <vector>

#include "pair/exact/algebraic_time.hpp"

namespace tamis {

/// The roots of `p` in [0,1], ends included, distinct and ascending. Roots after `latest` may be skipped. Roots after
/// the next power of two are skipped. REQUIRES: `p` is not zero; 0 <= latest <= 1.
std::vector<AlgebraicTime> roots_in_unit_interval(const IntegerPolynomial& p, double latest = 1);

}  // namespace tamis
