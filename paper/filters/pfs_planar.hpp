// Planar filter of PFS (Tang C., Li, Wang 2011): proves a pair free if, projected on one of eight planes, all relative
// positions lie in an open half-plane whose boundary passes through the origin. Cross products find the two outermost
// positions of the fan; the direction halfway between them is then tested like an axis of the linear filter, so the
// search needs no error bound of its own. Error bound: components in the plane are off by 4 * 2^-24, the direction has
// components up to 4, so the test is off by 2 * 4 * 4 + 2 * 8 + 16 = 64 * 2^-24 of the largest relative component.
// Cost: about 25 operations a relative position and register; for one pair at a time only.
#pragma once
#include "paper/filters/subspaces.hpp"

namespace tamis::lab {

struct PfsPlanar {
  static constexpr std::string_view name = "pfs-planar";

  template <PairKind kind>
  static bool proves_free(const PairMotion<double>& m) {
    const auto positions = subspaces::relative_positions<kind>(m);
    const Lanes error(subspaces::error_bound(m, 0x1p-17));
    for (std::size_t first = 0; first < subspaces::kSubspaces; first += Lanes::size) {
      std::array<InPlane, positions.size()> fan;
      for (std::size_t k = 0; k < fan.size(); ++k)
        fan[k] = {subspaces::project(positions[k], subspaces::kFirstInPlane, first),
                  subspaces::project(positions[k], subspaces::kSecondInPlane, first)};
      const InPlane direction = halfway(fan);
      auto proven = dot(fan[0], direction) > error;
      for (std::size_t k = 1; k < fan.size(); ++k) proven = proven & (dot(fan[k], direction) > error);
      if (xsimd::any(proven)) return true;
    }
    return false;
  }

 private:
  using Lanes = subspaces::Lanes;
  struct InPlane {
    Lanes u, v;
  };

  static Lanes dot(const InPlane& a, const InPlane& b) { return a.u * b.u + a.v * b.v; }
  static Lanes cross(const InPlane& a, const InPlane& b) { return a.u * b.v - a.v * b.u; }
  static InPlane normalized(const InPlane& a) {
    const Lanes length = xsimd::sqrt(dot(a, a));
    return {a.u / length, a.v / length};
  }

  /// Halfway between the rightmost and the leftmost vector, provided that all lie in some half-plane.
  template <std::size_t n>
  static InPlane halfway(const std::array<InPlane, n>& fan) {
    InPlane right = fan[0], left = fan[0];
    for (std::size_t k = 1; k < n; ++k) {
      const auto is_right = cross(right, fan[k])<Lanes(0), is_left = cross(left, fan[k])> Lanes(0);
      right = {xsimd::select(is_right, fan[k].u, right.u), xsimd::select(is_right, fan[k].v, right.v)};
      left = {xsimd::select(is_left, fan[k].u, left.u), xsimd::select(is_left, fan[k].v, left.v)};
    }
    right = normalized(right);
    left = normalized(left);
    // right + left is 0 for opposite vectors, the sum of their inner perpendiculars is 0 for equal ones; the sum of
    // both never is 0.
    return {right.u + left.u - right.v + left.v, right.v + left.v + right.u - left.u};
  }
};

}  // namespace tamis::lab
