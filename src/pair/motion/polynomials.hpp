// The polynomials in time of a pair's motion, as Bernstein coefficients without their binomials. (A coefficient i of
// degree n is C(n,i) times the Bernstein coefficient. Only its sign matters for culling.)
#pragma once
#include <array>

#include "numbers/error_bounds.hpp"
#include "numbers/select.hpp"
#include "pair/motion/pair_motion.hpp"

namespace tamis {

/// The product of two moving vectors, quadratic; `product` is bilinear.
template <class T, class Product>
inline auto product_polynomial(const Moving<T>& u, const Moving<T>& v, Product product) {
  using Result = decltype(product(u.at0, v.at0));
  return std::array<Result, 3>{product(u.at0, v.at0), product(u.at0, v.at1) + product(u.at1, v.at0),
                               product(u.at1, v.at1)};
}

/// n(t) = e(t) x f(t), quadratic. (The form n0 + n1 - (e1-e0) x (f1-f0) of the papers is equal, but cancels.)
template <class T>
inline std::array<Vec3<T>, 3> normal_polynomial(const Moving<T>& e, const Moving<T>& f) {
  return product_polynomial(e, f, [](const Vec3<T>& a, const Vec3<T>& b) { return cross(a, b); });
}

/// K(t) = d(t).n(t), cubic: zero iff the four points are coplanar (Provot 1997; Tang, Manocha, Tong 2010).
template <class T>
inline std::array<T, 4> coplanarity_polynomial(const Moving<T>& d, const std::array<Vec3<T>, 3>& n) {
  return {dot(d.at0, n[0]), dot(d.at0, n[1]) + dot(d.at1, n[0]), dot(d.at0, n[2]) + dot(d.at1, n[1]), dot(d.at1, n[2])};
}

template <class T>
inline std::array<T, 4> coplanarity_polynomial(const PairMotion<T>& m) {
  return coplanarity_polynomial(m.d, normal_polynomial(m.e, m.f));
}

/// True if the cubic may be zero at t=0, within its error. Doubles cannot decide pairs that are coplanar there, as
/// bodies at rest on each other often are.
template <class T>
inline Mask<T> may_start_coplanar(const PairMotion<T>& m) {
  const T k = dot(m.d.at0, cross(m.e.at0, m.f.at0));
  return abs(k) <= error_bounds::bound(error_bounds::kCoplanarityEnd, m.size_d * m.size_e * m.size_f);
}

/// The same cubic during [t_in, t_out], with that time mapped to [0,1]: its polar form at the two times (de Casteljau).
/// Off by less than the cubic of the restricted motion, whose errors are kCoplanarityEnd and kCoplanarityMiddle.
template <class T>
inline std::array<T, 4> restrict_to(const std::array<T, 4>& k, const T& t_in, const T& t_out) {
  const T before_in = T(1) - t_in, before_out = T(1) - t_out;
  const auto at_in = [&](const T& a, const T& b) { return before_in * a + t_in * b; };
  const auto at_out = [&](const T& a, const T& b) { return before_out * a + t_out * b; };
  const T b0 = T(3) * k[0], b3 = T(3) * k[3];
  const T in0 = at_in(b0, k[1]), in1 = at_in(k[1], k[2]), in2 = at_in(k[2], b3);
  const T out0 = at_out(b0, k[1]), out1 = at_out(k[1], k[2]), out2 = at_out(k[2], b3);
  const T in_in0 = at_in(in0, in1), in_in1 = at_in(in1, in2);
  const T out_out0 = at_out(out0, out1), out_out1 = at_out(out1, out2);
  return {T(1.0 / 3) * at_in(in_in0, in_in1), at_out(in_in0, in_in1), at_in(out_out0, out_out1),
          T(1.0 / 3) * at_out(out_out0, out_out1)};
}

/// M(t) = w(t) x n(t), cubic: normal of the moving plane that an edge with direction w and the pair's normal n span.
template <class T>
inline std::array<Vec3<T>, 4> edge_plane_polynomial(const Moving<T>& w, const std::array<Vec3<T>, 3>& n) {
  return {cross(w.at0, n[0]), cross(w.at0, n[1]) + cross(w.at1, n[0]), cross(w.at0, n[2]) + cross(w.at1, n[1]),
          cross(w.at1, n[2])};
}

/// S(t) = x(t).M(t), quartic: on which side of the edge plane a point lies, x being its difference to the edge.
template <class T>
inline std::array<T, 5> side_polynomial(const Moving<T>& x, const std::array<Vec3<T>, 4>& m) {
  return {dot(x.at0, m[0]), dot(x.at0, m[1]) + dot(x.at1, m[0]), dot(x.at0, m[2]) + dot(x.at1, m[1]),
          dot(x.at0, m[3]) + dot(x.at1, m[2]), dot(x.at1, m[3])};
}

}  // namespace tamis
