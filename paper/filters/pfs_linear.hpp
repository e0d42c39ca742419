// Linear filter of PFS (Tang C., Li, Wang 2011): proves a pair free if, projected on one of eight lines, all relative
// positions lie strictly on one side of the origin. SIMD lanes hold four or more lines; pairs are tested one by one.
// Error bound: conversion to float and three roundings, below 8 * 2^-24 of the largest relative component. Cost: about
// 12 operations a relative position and register.
#pragma once
#include "paper/filters/subspaces.hpp"

namespace tamis::lab {

struct PfsLinear {
  static constexpr std::string_view name = "pfs-linear";

  template <PairKind kind>
  static bool proves_free(const PairMotion<double>& m) {
    using subspaces::Lanes;
    const auto positions = subspaces::relative_positions<kind>(m);
    const float error = subspaces::error_bound(m, 0x1p-21);
    for (std::size_t first = 0; first < subspaces::kSubspaces; first += Lanes::size) {
      Lanes low = subspaces::project(positions[0], subspaces::kAxes, first), high = low;
      for (std::size_t k = 1; k < positions.size(); ++k) {
        const Lanes s = subspaces::project(positions[k], subspaces::kAxes, first);
        low = xsimd::min(low, s);
        high = xsimd::max(high, s);
      }
      if (xsimd::any(low > Lanes(error)) || xsimd::any(high < Lanes(-error))) return true;
    }
    return false;
  }
};

}  // namespace tamis::lab
