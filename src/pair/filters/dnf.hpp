// DNF, the deforming non-penetration filter (Tang, Manocha, Tong 2010). The four points are never coplanar. The proof:
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
    const T end = error_bounds::bound(error_bounds::kCoplanarityEnd, unit);
    const T middle = error_bounds::bound(error_bounds::kCoplanarityMiddle, unit);
    const auto k = coplanarity_polynomial(m);
    return ((k[0] > end) & (k[1] > middle) & (k[2] > middle) & (k[3] > end)) |
           ((k[0] < -end) & (k[1] < -middle) & (k[2] < -middle) & (k[3] < -end));
  }
};

}  // namespace tamis
