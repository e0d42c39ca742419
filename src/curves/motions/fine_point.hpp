// Turns intervals into answers of a path. These are numbers, each with a bound of its error.
#pragma once
#include <algorithm>

#include "numbers/interval.hpp"
#include "numbers/vec.hpp"
#include "tamis/path.hpp"

namespace tamis {

template <class T>
Vec3<BasicInterval<T>> enclosed(const Point& p) {
  using I = BasicInterval<T>;
  return {I(T(p[0])), I(T(p[1])), I(T(p[2]))};
}

struct RoundedNumber {
  double value, error;
};

/// The largest distance of a point of the interval from a number in it.
template <class T>
double farthest_from(const T& number, const BasicInterval<T>& x) {
  using I = BasicInterval<T>;
  return max(upper_double((I(x.upper) - I(number)).upper), upper_double((I(number) - I(x.lower)).upper));
}

inline double nearest_double(double x) { return x; }
inline double nearest_double(const DoubleDouble& x) { return x.high; }

template <class T>
RoundedNumber rounded_number(const BasicInterval<T>& x) {
  const double value = nearest_double(x.middle());
  return {value, farthest_from(T(value), x)};
}

inline FinePoint fine_point(const Vec3<FineInterval>& x) {
  FinePoint point;
  const auto set = [&](std::size_t k, const FineInterval& interval) {
    const DoubleDouble middle = interval.middle();
    point.high[k] = middle.high;
    point.low[k] = middle.low;
    point.error = std::max(point.error, farthest_from(middle, interval));
  };
  set(0, x.x);
  set(1, x.y);
  set(2, x.z);
  return point;
}

}  // namespace tamis
