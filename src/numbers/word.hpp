// Integers in machine words, for coordinates that fit. A product is exact and costs one multiplication, where an
// Estimate carries a bound along. Products of products are Estimates.
#pragma once
#include <cstdint>

#include "numbers/estimate.hpp"

namespace tamis {

/// Below 2^63 in size: coordinates of 61 bits (pair/exact/units.hpp), their differences, and differences of velocities.
/// REQUIRES, all operators (not checked: hot): the result fits.
struct Word {
  std::int64_t value = 0;

  operator Integer() const { return value; }
  operator Estimate() const { return Estimate::of(value); }
  int sign() const { return value > 0 ? 1 : value < 0 ? -1 : 0; }

  friend Word operator-(Word a) { return {-a.value}; }
  friend Word operator+(Word a, Word b) { return {a.value + b.value}; }
  friend Word operator-(Word a, Word b) { return {a.value - b.value}; }
};

/// Below 2^127: a product of two differences has 124 bits, a sum of three products 126, and a sum of two such sums 127.
struct WideWord {
  __extension__ using Wide = __int128;
  Wide value = 0;

  operator Estimate() const { return Estimate::of(value); }
  int sign() const { return value > 0 ? 1 : value < 0 ? -1 : 0; }

  friend WideWord operator-(WideWord a) { return {-a.value}; }
  friend WideWord operator+(WideWord a, WideWord b) { return {a.value + b.value}; }
  friend WideWord operator-(WideWord a, WideWord b) { return {a.value - b.value}; }
};

inline WideWord operator*(Word a, Word b) { return {WideWord::Wide{a.value} * b.value}; }
inline Estimate operator*(const WideWord& a, const WideWord& b) { return Estimate(a) * Estimate(b); }

}  // namespace tamis
