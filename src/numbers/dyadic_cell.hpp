// The interval (n, n+1) / 2^k that encloses a time. Two such cells are nested or disjoint. The gap between two
// neighbouring doubles is one of them.
#pragma once
#include "numbers/integer.hpp"

namespace tamis {

struct DyadicCell {
  Integer n{0};
  int k = 0;

  DyadicCell left_half() const { return {n << 1, k + 1}; }
  DyadicCell right_half() const { return {(n << 1) + 1, k + 1}; }
  /// The cell `p` of [0,1], mapped into this one.
  DyadicCell part(const DyadicCell& p) const { return {(n << p.k) + p.n, k + p.k}; }
};

/// The cell whose lower end is `lower` and whose upper end is the next double.
/// REQUIRES: 0 <= lower <= 1.
DyadicCell cell_above(double lower);

/// The cell with the least k whose lower end is the time: n is odd, or k = 0. Its numbers are shorter than the numbers
/// of cell_above(), which has k = 1074 at t = 0. REQUIRES: 0 <= time <= 1.
DyadicCell shortest_cell_at(double time);

/// The double halfway between a and b in the order of the doubles: 62 halvings separate any two. REQUIRES: 0 <= a <= b.
double middle_double(double a, double b);

/// The sign of the lower end of `a` minus the lower end of `b`.
int compare_lower_ends(const DyadicCell& a, const DyadicCell& b);

/// A time strictly between the lower ends, of few bits. REQUIRES: `a` before `b`.
DyadicCell between(const DyadicCell& a, const DyadicCell& b);

/// The largest double that is not above n / 2^k.
/// REQUIRES: 0 <= n <= 2^k.
double lower_end(const DyadicCell& cell);

/// True if n / 2^k is a double.
bool lower_end_is_double(const DyadicCell& cell);

}  // namespace tamis
