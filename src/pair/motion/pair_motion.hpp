// The linear motion of one pair of features, relative to itself: three moving vectors.
//   vertex-face p against a,b,c:   e = b - a,    f = c - a,    d = p - a
//   edge-edge   a0a1 against b0b1: e = a1 - a0,  f = b1 - b0,  d = b0 - a0
//   vertex-edge p against a,b:     e = b - a,    f = 0,        d = p - a
//   vertex-vertex p against q:     e = 0,        f = 0,        d = p - q
// One template on the number type T: double, SIMD lanes, double-double, interval, integers.
#pragma once
#include <cmath>

#include "numbers/assert.hpp"
#include "numbers/unit_vector.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// A vector that goes linearly from `at0` (t=0) to `at1` (t=1).
template <class T>
struct Moving {
  Vec3<T> at0, at1;

  bool operator==(const Moving&) const = default;
};

template <class T>
inline Moving<T> operator-(const Moving<T>& a, const Moving<T>& b) {
  return {a.at0 - b.at0, a.at1 - b.at1};
}
template <class T>
inline Moving<T> operator+(const Moving<T>& a, const Moving<T>& b) {
  return {a.at0 + b.at0, a.at1 + b.at1};
}
template <class T>
inline Moving<T> operator-(const Moving<T>& a) {
  return {-a.at0, -a.at1};
}

/// Largest |component| at both ends.
template <class T>
inline T largest(const Moving<T>& v) {
  return max(largest_component(v.at0), largest_component(v.at1));
}

/// `size_*` bound every |component| of the unrestricted vector: the unit of its rounding errors. They stay the sizes of
/// the whole step when the motion is restricted to a part of it. `separation`: features this close count as touching;
/// zero where only touching does.
template <class T>
struct PairMotion {
  Moving<T> e, f, d;
  T size_e, size_f, size_d;
  T separation = T(0);
};

inline bool is_finite(const PairMotion<double>& m) { return std::isfinite(m.size_e + m.size_f + m.size_d); }

/// True if this can be the motion of a whole step, with the sizes of just these vectors. Motions that are not finite,
/// and number types other than double, are not checked: true for these.
inline bool may_be_whole(const PairMotion<double>& m) {
  return !is_finite(m) || (m.size_e == largest(m.e) && m.size_f == largest(m.f) && m.size_d == largest(m.d));
}
template <class T>
constexpr bool may_be_whole(const PairMotion<T>&) {
  return true;
}
/// True if the motion is finite and not restricted.
inline bool is_whole(const PairMotion<double>& m) { return is_finite(m) && may_be_whole(m); }
template <class T>
constexpr bool is_whole(const PairMotion<T>&) {
  return true;
}

/// Position of the vector at time t. Off by at most 3 u times its size.
template <class T>
inline Vec3<T> at_time(const Moving<T>& v, const T& t) {
  const T s = T(1) - t;
  return s * v.at0 + t * v.at1;
}

template <class T>
inline Moving<T> restrict_to(const Moving<T>& v, const T& t_in, const T& t_out) {
  return {at_time(v, t_in), at_time(v, t_out)};
}

/// The motion during [t_in, t_out], with that time mapped to [0,1]. REQUIRES: `m` is not itself restricted.
template <class T>
inline PairMotion<T> restrict_to(const PairMotion<T>& m, const T& t_in, const T& t_out) {
  TAMIS_ASSERT(may_be_whole(m));
  return {restrict_to(m.e, t_in, t_out),
          restrict_to(m.f, t_in, t_out),
          restrict_to(m.d, t_in, t_out),
          m.size_e,
          m.size_f,
          m.size_d,
          m.separation};
}

}  // namespace tamis
