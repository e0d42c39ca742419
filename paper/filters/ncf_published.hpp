// NCF as published (Du, Tang, Tong 2012, Algorithms 1 and 2). The inner side of an edge's plane is the one on which the
// face's opposite corner lies. Algorithm 1 (VF) first asks whether that corner stays on the inner side, that is whether
// the triangle never turns over; then whether the point stays on the outer side for one of the three edges. Algorithm 2
// (EE) asks whether both ends of one edge stay on one side of the plane through the other edge.
// We deviate: strict signs after an error bound; n = (a1-a0) x (b1-b0) for EE, which the paper leaves open; the corner
// is tested once, because its five coefficients are those of -|n|^2 for each of the three edges. Ncf does not test it.
// Error bound: error_bounds::kSide*. Cost: VF about 500 operations, EE about 470; less when an early edge culls.
#pragma once
#include "pair/filters/ncf.hpp"

namespace tamis::lab {

struct NcfPublished {
  static constexpr std::string_view name = "ncf-published";

  template <PairKind kind, class T>
  static Mask<T> proves_free(const PairMotion<T>& m) {
    if constexpr (kind == PairKind::vertex_face) {
      const auto corner_plane = edge_plane_polynomial(m.e, normal_polynomial(m.e, m.f));
      const auto corner = side_polynomial(m.f - m.e, corner_plane);
      const T size = m.size_e + m.size_f;
      return side::all_negative(corner, side::bounds(m, size, m.size_e)) & Ncf::proves_free<kind>(m);
    } else {
      return Ncf::proves_free<kind>(m);
    }
  }
};

}  // namespace tamis::lab
