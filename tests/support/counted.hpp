// A double that counts its operations: those that a filter or a solver costs, before the compiler optimizes them. For
// one thread only.
#pragma once
#include <cstdint>

#include "numbers/error_bounds.hpp"
#include "numbers/select.hpp"

namespace tamis::test {

struct Operations {
  std::int64_t additions = 0;  ///< and subtractions
  std::int64_t multiplications = 0;
  std::int64_t divisions = 0;

  friend bool operator==(const Operations&, const Operations&) = default;
};

struct Counted {
  double value = 0;
  static inline Operations total;

  Counted() = default;
  explicit Counted(double v) : value(v) {}

  friend Counted operator+(Counted a, Counted b) { return counted(total.additions, a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return counted(total.additions, a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return counted(total.multiplications, a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return counted(total.divisions, a.value / b.value); }
  friend Counted operator-(Counted a) { return Counted(-a.value); }
  friend auto operator<=>(const Counted& a, const Counted& b) { return a.value <=> b.value; }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value == b.value; }

  friend Counted select(bool mask, Counted yes, Counted no) { return mask ? yes : no; }
  friend Counted min(Counted a, Counted b) { return Counted(tamis::min(a.value, b.value)); }
  friend Counted max(Counted a, Counted b) { return Counted(tamis::max(a.value, b.value)); }
  friend Counted abs(Counted a) { return Counted(tamis::abs(a.value)); }

 private:
  static Counted counted(std::int64_t& operations, double result) {
    ++operations;
    return Counted(result);
  }
};

/// The operations that `f` costs.
template <class F>
Operations operations_of(const F& f) {
  Counted::total = {};
  f();
  return Counted::total;
}

}  // namespace tamis::test

namespace tamis::error_bounds {
template <>
inline constexpr double unit_roundoff<test::Counted> = unit_roundoff<double>;
}  // namespace tamis::error_bounds
