// The motion of a pair in exact rationals, for the library's templates on a number type that never rounds.
#pragma once
#include <gmpxx.h>

#include "oracle/oracle.hpp"
#include "pair/motion/make_motion.hpp"

namespace tamis::test {

/// mpq_class without expression templates: the library's generic formulas need one type for all results.
struct Exact {
  mpq_class value;
  Exact(double x = 0) : value(x) {}
  explicit Exact(mpq_class x) : value(std::move(x)) {}

  friend Exact operator+(const Exact& a, const Exact& b) { return Exact(mpq_class(a.value + b.value)); }
  friend Exact operator-(const Exact& a, const Exact& b) { return Exact(mpq_class(a.value - b.value)); }
  friend Exact operator*(const Exact& a, const Exact& b) { return Exact(mpq_class(a.value * b.value)); }
  friend Exact operator-(const Exact& a) { return Exact(mpq_class(-a.value)); }
  friend bool operator==(const Exact& a, const Exact& b) { return a.value == b.value; }
};

/// The exact motion times `scale`. Its sizes stay zero.
PairMotion<Exact> exact_motion(PairKind kind, const oracle::Motion& motion, const Exact& scale = 1.0);

}  // namespace tamis::test
