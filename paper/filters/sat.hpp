// SAT, the separating axis test for moving features on constant axes (after Tang, Manocha, Yoon, Du, Heo, Tong 2011):
// along an axis, the difference of a point of one feature and a point of the other is linear in time. If all
// differences have one strict sign at t=0 and at t=1, the features are apart during the whole step. Axes: the pair's
// normal e x f, and its cross products with the edges, at t=0 and at t=1. Any axis is sound, however it is rounded.
// We deviate: their axes may also be polynomials of time; DNF (the normal) and NCF (edge x normal) are those tests.
// Error bound: kAxisProjection times the axis' largest component. Cost: 8 (VF) or 6 (EE) axes of about 50.
#pragma once
#include "pair/filters/filter.hpp"
#include "pair/motion/difference_corners.hpp"

namespace tamis::lab {

struct Sat {
  static constexpr std::string_view name = "sat";

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    return either(separates_along_frame<kind>(m, m.e.at0, m.f.at0),
                  [&] { return separates_along_frame<kind>(m, m.e.at1, m.f.at1); });
  }

 private:
  /// The error of a difference projected on any axis, unit |axis|_max (D + E + F): three products of a factor off by
  /// kInput, 3 (8 + 1), and sums 3 + 3; the difference of projections 2 * 3 more: below 42.
  static constexpr double kAxisProjection = 48;

  /// Tests the axes that the features have at one time.
  template <PairKind kind, class T>
  static Mask<T> separates_along_frame(const PairMotion<T>& m, const Vec3<T>& e, const Vec3<T>& f) {
    const Vec3<T> n = cross(e, f);
    const auto along_others = [&] {
      return either(separates<kind>(m, cross(e, n)), [&] { return separates<kind>(m, cross(f, n)); });
    };
    const auto others = [&]() -> Mask<T> {
      if constexpr (kind == PairKind::vertex_face)
        return either(along_others(), [&] { return separates<kind>(m, cross(f - e, n)); });
      else
        return along_others();
    };
    return either(separates<kind>(m, n), others);
  }

  template <PairKind kind, class T>
  static Mask<T> separates(const PairMotion<T>& m, const Vec3<T>& axis) {
    const auto at0 = range_of_differences<kind>(dot(axis, m.e.at0), dot(axis, m.f.at0), dot(axis, m.d.at0));
    const auto at1 = range_of_differences<kind>(dot(axis, m.e.at1), dot(axis, m.f.at1), dot(axis, m.d.at1));
    const T size = max(max(abs(axis.x), abs(axis.y)), abs(axis.z));
    const T error = error_bounds::bound<T>(kAxisProjection, size * (m.size_d + m.size_e + m.size_f));
    return ((at0.low > error) & (at1.low > error)) | ((at0.high < -error) & (at1.high < -error));
  }
};

}  // namespace tamis::lab
