// The sixteen lanes of a block: in batches, and by the bits of a mask.
#pragma once
#include <bit>

#include "numbers/lanes.hpp"
#include "numbers/platform.hpp"
#include "search/bounds/moving_boxes.hpp"

namespace tamis::TAMIS_ISA {

/// Calls f(first) for the batches that make up sixteen lanes.
template <class F>
TAMIS_ALWAYS_INLINE void for_sixteen_lanes(const F& f) {
  for (int first = 0; first < kBlock; first += kFloatLanes) f(first);
}

/// Bits of sixteen lanes. `mask_at(first)`: the mask of a batch of them.
template <class F>
TAMIS_ALWAYS_INLINE unsigned bits_of_sixteen(const F& mask_at) {
  unsigned all = 0;
  for_sixteen_lanes([&](int first) { all |= bits(mask_at(first)) << first; });
  return all;
}

/// Of sixteen numbers, the batch from `first` on.
inline FloatLanes lanes_of(const float (&sixteen)[kBlock], int first) {
  return FloatLanes::load_aligned(sixteen + first);
}

/// Calls f(lane) for the bits of a mask, lowest first.
template <class F>
inline void for_each_bit(unsigned mask, const F& f) {
  for (; mask; mask &= mask - 1) f(std::countr_zero(mask));
}

}  // namespace tamis::TAMIS_ISA
