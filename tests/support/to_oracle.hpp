// The library's integers as the oracle's.
#pragma once
#include "numbers/integer.hpp"
#include "oracle/exact_numbers.hpp"

namespace tamis::test {

inline oracle::Integer to_oracle(const Integer& a) {
  constexpr int kWord = 64;
  oracle::Integer size = 0;
  for (int first = a.bits() / kWord * kWord; first >= 0; first -= kWord) size = (size << kWord) + a.bits_from(first);
  return a.sign() < 0 ? -size : size;
}

}  // namespace tamis::test
