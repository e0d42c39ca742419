// Do the features of a pair meet at the time at which their four points are coplanar? For double and for SIMD lanes.
#pragma once
#include "motion/pair_kinds.hpp"
#include "motion/pair_motion.hpp"
#include "numerics/error_bounds.hpp"
#include "numerics/select.hpp"

namespace tamis::crossing {

/// How far a component goes at most, rounding included (the difference is off by 11 u of the size).
template <class T>
inline T change(const Moving<T>& v) {
  const Vec3<T> x = v.at1 - v.at0;
  return max(max(abs(x.x), abs(x.y)), abs(x.z));
}

template <class T>
struct Sides {
  Mask<T> inside, outside;
  T u, v;
};

/// Where the four points stand at time t, give or take r: certainly inside, certainly outside, or neither.
template <PairKind kind, class T>
inline Sides<T> sides(const PairMotion<T>& m, const Vec3<T>& n, const T& t, const T& r) {
  const Vec3<T> e = at_time(m.e, t), f = at_time(m.f, t), d = at_time(m.d, t);
  const T unit = m.size_e * m.size_f, change_e = change(m.e), change_f = change(m.f), change_d = change(m.d);
  const T change_unit = change_e * m.size_f + m.size_e * change_f;
  const auto margin = [&](const T& size_x, const T& size_w, const T& change_x, const T& change_w) {
    const T slope = (change_x * size_w + size_x * change_w) * unit + size_x * size_w * change_unit;
    return error_bounds::bound(error_bounds::kSideValue, (T(1) + T(2) * r) * (size_x * size_w * unit)) +
           T(error_bounds::kSideSlope) * r * slope;
  };
  const T norm2 = dot(n, n);
  const Vec3<T> ne = cross(e, n), nf = cross(f, n);
  if constexpr (kind == PairKind::vertex_face) {
    const T ab = dot(d, ne), ca = -dot(d, nf), bc = dot(d - e, nf - ne);
    const T margin_ab = margin(m.size_d, m.size_e, change_d, change_e);
    const T margin_ca = margin(m.size_d, m.size_f, change_d, change_f);
    const T margin_bc = margin(m.size_d + m.size_e, m.size_e + m.size_f, change_d + change_e, change_e + change_f);
    return {Mask<T>((ab < -margin_ab) & (ca < -margin_ca) & (bc < -margin_bc)),
            Mask<T>((ab > margin_ab) | (ca > margin_ca) | (bc > margin_bc)), -ca / norm2, -ab / norm2};
  } else {
    const T b0 = dot(d, ne), b1 = dot(d + f, ne), a0 = -dot(d, nf), a1 = dot(e - d, nf);
    const T margin_b0 = margin(m.size_d, m.size_e, change_d, change_e);
    const T margin_b1 = margin(m.size_d + m.size_f, m.size_e, change_d + change_f, change_e);
    const T margin_a0 = margin(m.size_d, m.size_f, change_d, change_f);
    const T margin_a1 = margin(m.size_d + m.size_e, m.size_f, change_d + change_e, change_f);
    return {Mask<T>((b0 > margin_b0) & (b1 < -margin_b1) & (a0 < -margin_a0) & (a1 > margin_a1)),
            Mask<T>((b0 < -margin_b0) | (b1 > margin_b1) | (a0 > margin_a0) | (a1 < -margin_a1)), -a0 / norm2,
            b0 / norm2};
  }
}

}  // namespace tamis::crossing
