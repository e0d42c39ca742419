// The few operations that double lacks but SIMD lanes have, so one template serves both.
#pragma once
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/vec.hpp"

namespace tamis {

/// Result of a comparison: bool for double, a lane mask for SIMD lanes.
template <class T>
using Mask = decltype(std::declval<T>() > std::declval<T>());

/// A number as a constant of type T: a scalar, or the same in every lane.
template <class T>
inline T constant(double value) {
  if constexpr (requires { typename T::value_type; })
    return T(static_cast<typename T::value_type>(value));
  else
    return T(value);
}

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
template <class Mask, class T>
inline Vec3<T> select(const Mask& mask, const Vec3<T>& yes, const Vec3<T>& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
/// b where either is NaN, as of x86's instructions; ARM's return NaN.
inline double min(double a, double b) { return a < b ? a : b; }
inline double max(double a, double b) { return a > b ? a : b; }
inline double abs(double a) { return std::fabs(a); }
inline double sqrt(double a) { return std::sqrt(a); }
inline bool any(bool mask) { return mask; }

/// Selections that lanes specialize. With a constant on one side they are one operation where a mask is as wide as the
/// numbers. Most processors have an instruction for the others.
template <class T>
struct Masked {
  template <class Mask>
  static T zero_unless(const Mask& mask, const T& a) {
    return select(mask, a, T(0));
  }
  template <class Mask>
  static T nan_where(const Mask& mask, const T& a) {
    return select(mask, constant<T>(std::numeric_limits<double>::quiet_NaN()), a);
  }
  /// The smaller and the larger of two: b where a is NaN.
  static T min_number(const T& a, const T& b) { return select(a < b, a, b); }
  static T max_number(const T& a, const T& b) { return select(a > b, a, b); }
};

/// a / b, off by at most kError of itself. REQUIRES (not checked: lanes): b is not 0 where the result is used.
template <class T>
struct Ratio {
  static constexpr double kError = 0x1p-53;
  static T of(const T& a, const T& b) { return a / b; }
};

}  // namespace tamis
