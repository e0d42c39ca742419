// The eight subspaces of the parallel filters (PFS: Tang C., Li, Wang 2011), one a SIMD lane, and the relative
// positions that are projected on them. If the features touch at some time, the origin lies in the convex hull of the
// positions of one feature's points relative to the other's, at t=0 and at t=1: six vectors for VF, eight for EE.
// We deviate: the paper's directions are not available; ours are the eight axes of the 16-DOP.
#pragma once
#include <array>
#include <limits>
#include <xsimd/xsimd.hpp>

#include "numbers/axes.hpp"
#include "pair/filters/filter.hpp"

namespace tamis::lab::subspaces {

using Lanes = xsimd::batch<float>;
inline constexpr std::size_t kSubspaces = 8;
/// Lanes beyond the eighth repeat the subspaces.
inline constexpr std::size_t kEntries = Lanes::size > kSubspaces ? Lanes::size : kSubspaces;

/// One vector a lane: table[axis][lane] is a component.
using Table = std::array<std::array<float, kEntries>, 3>;

constexpr Table repeated(const std::array<std::array<float, 3>, kSubspaces>& vectors) {
  Table table{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < kEntries; ++i) table[axis][i] = vectors[i % kSubspaces][axis];
  return table;
}

/// Directions of the lines, which are also the normals of the planes; and two orthogonal vectors in each plane.
inline constexpr Table kAxes =
    repeated({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}}});
inline constexpr Table kFirstInPlane =
    repeated({{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, -1, 0}, {1, 1, 0}, {1, 0, -1}, {1, 0, 1}, {0, 1, -1}}});
inline constexpr Table kSecondInPlane =
    repeated({{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}}});

using FloatVec = std::array<float, 3>;

inline FloatVec to_float(const Vec3<double>& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// p-a, p-b, p-c at both ends; or b_j - a_i at both ends.
template <PairKind kind>
inline auto relative_positions(const PairMotion<double>& m) {
  const auto d0 = m.d.at0, d1 = m.d.at1;
  if constexpr (kind == PairKind::vertex_face)
    return std::array{to_float(d0), to_float(d0 - m.e.at0), to_float(d0 - m.f.at0),
                      to_float(d1), to_float(d1 - m.e.at1), to_float(d1 - m.f.at1)};
  else
    return std::array{to_float(d0), to_float(d0 + m.f.at0), to_float(d0 - m.e.at0), to_float(d0 + m.f.at0 - m.e.at0),
                      to_float(d1), to_float(d1 + m.f.at1), to_float(d1 - m.e.at1), to_float(d1 + m.f.at1 - m.e.at1)};
}

/// Projection of `v` on one vector a lane.
inline Lanes project(const FloatVec& v, const Table& on, std::size_t first) {
  return Lanes(v[0]) * Lanes::load_unaligned(&on[0][first]) + Lanes(v[1]) * Lanes::load_unaligned(&on[1][first]) +
         Lanes(v[2]) * Lanes::load_unaligned(&on[2][first]);
}

/// `relative` times a bound of the relative positions' components, plus a bound of float's underflow.
inline float error_bound(const PairMotion<double>& m, double relative) {
  return static_cast<float>(relative * (m.size_d + m.size_e + m.size_f)) + std::numeric_limits<float>::min();
}

}  // namespace tamis::lab::subspaces
