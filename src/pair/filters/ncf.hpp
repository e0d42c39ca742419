// NCF, the deforming non-collinear filter, in its stronger form. The published test whether the triangle turns over is
// omitted, because the strict signs imply it (paper/README.md).
//   VF: the point stays on the outer side of one edge of the face. With n = (b-a) x (c-a) the opposite corner is
//       always on the other side, (c-b).((b-a) x n) = -|n|^2. So one sign of the point's quartic suffices.
//   EE: n = (a1-a0) x (b1-b0). Both ends of one edge stay strictly on one side of the plane through the other and n.
// Error bound: error_bounds::kSide*. Cost: about 400 operations for VF, 470 for EE.
#pragma once
#include "pair/filters/filter.hpp"
#include "pair/motion/polynomials.hpp"

namespace tamis {

namespace side {

/// Bounds on the error of the five coefficients of S = x.(w x n) with |x| <= size_x, |w| <= size_w, n = e x f.
template <class T>
struct Bounds {
  T end, next, middle;
};

template <class T>
inline Bounds<T> bounds(const PairMotion<T>& m, const T& size_x, const T& size_w) {
  const T unit = size_x * size_w * m.size_e * m.size_f;
  return {error_bounds::bound(error_bounds::kSideEnd, unit), error_bounds::bound(error_bounds::kSideNext, unit),
          error_bounds::bound(error_bounds::kSideMiddle, unit)};
}

template <class T>
inline auto all_positive(const std::array<T, 5>& s, const Bounds<T>& b) {
  return (s[0] > b.end) & (s[1] > b.next) & (s[2] > b.middle) & (s[3] > b.next) & (s[4] > b.end);
}

template <class T>
inline auto all_negative(const std::array<T, 5>& s, const Bounds<T>& b) {
  return (s[0] < -b.end) & (s[1] < -b.next) & (s[2] < -b.middle) & (s[3] < -b.next) & (s[4] < -b.end);
}

}  // namespace side

struct Ncf {
  static constexpr std::string_view name = "ncf";

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    const auto n = normal_polynomial(m.e, m.f);
    if constexpr (kind == PairKind::vertex_face)
      return either(stays_outside(m, n, m.d, m.size_d, m.e, m.size_e), [&] {
        return either(stays_outside(m, n, m.d, m.size_d, -m.f, m.size_f), [&] {
          return stays_outside(m, n, m.d - m.e, m.size_d + m.size_e, m.f - m.e, m.size_e + m.size_f);
        });
      });
    else
      return either(one_side(m, n, m.d, m.d + m.f, m.size_d + m.size_f, m.e, m.size_e),
                    [&] { return one_side(m, n, -m.d, m.e - m.d, m.size_d + m.size_e, m.f, m.size_f); });
  }

 private:
  template <class T>
  using Normal = std::array<Vec3<T>, 3>;

  template <class T>
  static Mask<T> stays_outside(const PairMotion<T>& m, const Normal<T>& n, const Moving<T>& x, const T& size_x,
                               const Moving<T>& w, const T& size_w) {
    return side::all_positive(side_polynomial(x, edge_plane_polynomial(w, n)), side::bounds(m, size_x, size_w));
  }

  /// `x`, `y`: from a point of the edge with direction `w` to the two ends of the other edge.
  template <class T>
  static Mask<T> one_side(const PairMotion<T>& m, const Normal<T>& n, const Moving<T>& x, const Moving<T>& y,
                          const T& size, const Moving<T>& w, const T& size_w) {
    const auto plane = edge_plane_polynomial(w, n);
    const auto bounds = side::bounds(m, size, size_w);
    const auto sx = side_polynomial(x, plane), sy = side_polynomial(y, plane);
    return (side::all_positive(sx, bounds) & side::all_positive(sy, bounds)) |
           (side::all_negative(sx, bounds) & side::all_negative(sy, bounds));
  }
};

}  // namespace tamis
