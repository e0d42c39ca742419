// The few operations that double lacks but SIMD lanes have, so that one template serves both.
#pragma once
#include <cmath>

namespace tamis {

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
/// As the lanes' instructions have it: b where either is NaN.
inline double min(double a, double b) { return a < b ? a : b; }
inline double max(double a, double b) { return a > b ? a : b; }
inline double abs(double a) { return std::fabs(a); }
inline double sqrt(double a) { return std::sqrt(a); }
inline bool any(bool mask) { return mask; }

/// a / b, off by at most kError of itself. REQUIRES: b is not 0 where the result is used.
template <class T>
struct Ratio {
  static constexpr double kError = 0x1p-53;
  static T of(const T& a, const T& b) { return a / b; }
};

}  // namespace tamis
