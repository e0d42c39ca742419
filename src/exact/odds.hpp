// Times between 0 and 1 as their odds s = t / (1 - t), which grow from 0 to infinity: doubles with room for any
// exponent are as fine beside t = 1 as beside t = 0.
#pragma once
#include <optional>

#include "exact/dyadic_cell.hpp"

namespace tamis {

/// s = mantissa 2^exponent. The mantissa is in [1/2, 1].
struct Odds {
  double mantissa = 0.5;
  long exponent = 0;
};

/// Closed; with one root inside, a simple one.
struct OddsBracket {
  Odds low, high;
  int sign_before = 0;  ///< of the polynomial from `low` to the root

  /// Doubles on either side of the time.
  double lower_time() const;
  double upper_time() const;
  /// Around the time and between neighbouring doubles, 2^-15 of its distance from 0 or 1 wide, or less; none if that is
  /// not certain.
  std::optional<DyadicCell> cell() const;
};

}  // namespace tamis
