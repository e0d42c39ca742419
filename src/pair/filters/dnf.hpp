// DNF, the deforming non-penetration filter (Tang, Manocha, Tong 2010): the four points are never coplanar, because
// all coefficients of the coplanarity cubic have one strict sign.
// Error bound: error_bounds::kCoplanarity*. Cost: about 110 operations.
#pragma once
#include "pair/filters/filter.hpp"
#include "pair/motion/polynomials.hpp"

namespace tamis {

struct Dnf {
  static constexpr std::string_view name = "dnf";

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    const T unit = m.size_d * m.size_e * m.size_f;
    return has_one_sign(coplanarity_polynomial(m), error_bounds::bound(error_bounds::kCoplanarityEnd, unit),
                        error_bounds::bound(error_bounds::kCoplanarityMiddle, unit));
  }

  /// Proves free every motion, straight or not, whose vertices are never farther than `deviation` from the vertices of
  /// `m` along any axis (docs/numerics/steps.md: "Pairs listed ahead").
  template <PairKind kind, class T>
  static Mask<T> proves_free_though_deviating(const PairMotion<T>& m, const T& deviation) {
    const T x = T(2) * deviation, d = m.size_d, e = m.size_e, f = m.size_f, unit = d * e * f;
    const T change = T(6 * kRoundedUp) * (x * (d * e + d * f + e * f) + x * x * (d + e + f + x));
    return has_one_sign(coplanarity_polynomial(m), change + error_bounds::bound(error_bounds::kCoplanarityEnd, unit),
                        T(3) * change + error_bounds::bound(error_bounds::kCoplanarityMiddle, unit));
  }

 private:
  /// Are all coefficients of one sign, beyond their errors?
  template <class T>
  static Mask<T> has_one_sign(const std::array<T, 4>& k, const T& end, const T& middle) {
    return ((k[0] > end) & (k[1] > middle) & (k[2] > middle) & (k[3] > end)) |
           ((k[0] < -end) & (k[1] < -middle) & (k[2] < -middle) & (k[3] < -end));
  }
};

}  // namespace tamis
