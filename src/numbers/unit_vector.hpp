// The largest component of a vector, and the unit vector along it.
#pragma once
#include "numbers/select.hpp"
#include "numbers/vec.hpp"

namespace tamis {

/// |v|_max.
template <class T>
inline T largest_component(const Vec3<T>& v) {
  return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

/// v / |v|; NaN where `v` is zero or NaN. Divides by the largest component first, so no square underflows.
template <class T>
inline Vec3<T> unit_vector(const Vec3<T>& v) {
  const T size = largest_component(v);
  const Vec3<T> scaled{v.x / size, v.y / size, v.z / size};
  return (T(1) / sqrt(dot(scaled, scaled))) * scaled;
}

}  // namespace tamis
