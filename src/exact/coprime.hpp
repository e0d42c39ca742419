// A quick proof that two integer polynomials have no common factor: they have none modulo a prime.
#pragma once
#include "exact/integer_polynomial.hpp"

namespace tamis {

/// True only if proven. A common factor of degree d keeps it modulo a prime that does not divide its leading
/// coefficient, and so not one of theirs. REQUIRES: neither is zero.
bool are_surely_coprime(const IntegerPolynomial& a, const IntegerPolynomial& b);

}  // namespace tamis
