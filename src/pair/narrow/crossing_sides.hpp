// The inside test: tells whether the features of a pair meet at the time when their four points are coplanar. For
// double, double-double and SIMD lanes.
#pragma once
#include "numbers/error_bounds.hpp"
#include "numbers/select.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/motion/pair_motion.hpp"

namespace tamis::crossing {

/// u, v and per_norm2 have a meaning only where `inside`. There |n|^2 is larger than the margins that the sides exceed.
/// So it can be a divisor.
template <class T>
struct Sides {
  Mask<T> inside, outside;
  T u, v;       ///< weights, see Contact
  T per_norm2;  ///< 1 / |n|^2
};

/// Where the four points stand at time t, give or take r: certainly inside, certainly outside, or neither.
template <PairKind kind, class T>
inline Sides<T> sides(const PairMotion<T>& m, const Vec3<T>& n, const T& t, const T& r) {
  const Vec3<T> e = at_time(m.e, t), f = at_time(m.f, t), d = at_time(m.d, t);
  const T error = T(error_bounds::kSideValue * error_bounds::unit_roundoff<T>) + T(error_bounds::kSideSlope) * r;
  const T unit = error * (m.size_e * m.size_f);
  const auto margin = [&](const T& size_x, const T& size_w) {
    return size_x * size_w * unit + T(error_bounds::underflow<T>);
  };
  const T per_norm2 = T(1) / dot(n, n);
  const Vec3<T> ne = cross(e, n), nf = cross(f, n);
  if constexpr (kind == PairKind::vertex_face) {
    const T ab = dot(d, ne), ca = -dot(d, nf), bc = dot(d - e, nf - ne);
    const T margin_ab = margin(m.size_d, m.size_e);
    const T margin_ca = margin(m.size_d, m.size_f);
    const T margin_bc = margin(m.size_d + m.size_e, m.size_e + m.size_f);
    return {Mask<T>((ab < -margin_ab) & (ca < -margin_ca) & (bc < -margin_bc)),
            Mask<T>((ab > margin_ab) | (ca > margin_ca) | (bc > margin_bc)), -ca * per_norm2, -ab * per_norm2,
            per_norm2};
  } else {
    const T b0 = dot(d, ne), b1 = dot(d + f, ne), a0 = -dot(d, nf), a1 = dot(e - d, nf);
    const T margin_b0 = margin(m.size_d, m.size_e);
    const T margin_b1 = margin(m.size_d + m.size_f, m.size_e);
    const T margin_a0 = margin(m.size_d, m.size_f);
    const T margin_a1 = margin(m.size_d + m.size_e, m.size_f);
    return {Mask<T>((b0 > margin_b0) & (b1 < -margin_b1) & (a0 < -margin_a0) & (a1 > margin_a1)),
            Mask<T>((b0 < -margin_b0) | (b1 > margin_b1) | (a0 > margin_a0) | (a1 < -margin_a1)), -a0 * per_norm2,
            b0 * per_norm2, per_norm2};
  }
}

}  // namespace tamis::crossing
