// The motion of a pair in exact rationals, for the library's templates on a number type that never rounds.
#pragma once
#include "oracle/exact_numbers.hpp"
#include "oracle/oracle.hpp"
#include "pair/motion/make_motion.hpp"

namespace tamis::test {

using oracle::Rational;

/// The exact motion times `scale`. Its sizes stay zero.
PairMotion<Rational> exact_motion(PairKind kind, const oracle::Motion& motion, const Rational& scale = 1);

}  // namespace tamis::test
