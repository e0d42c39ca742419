// A filter is a stateless struct with a name and one certificate over pairs of features.
//
//   struct Example {
//     static constexpr std::string_view name = "example";
//     template <PairKind kind, class T>
//     static Mask<T> proves_free(const PairMotion<T>& m);
//   };
//
// `proves_free` is true only where the pair is proven apart during the whole of the (possibly restricted) motion,
// rounding included. Sizes that overflowed must come out false. A component is NaN only where its vector's size is NaN.
// Positions are checked at the boundary. A difference of finite numbers is finite, or it is infinite, and its size is
// then, too. T is double, an interval, or SIMD lanes of doubles or floats.
#pragma once
#include <string_view>
#include <type_traits>

#include "numbers/error_bounds.hpp"
#include "numbers/select.hpp"
#include "pair/motion/pair_motion.hpp"

namespace tamis {

/// a | b(): for a single pair, `b` is skipped where `a` is true. Lanes compute both.
template <class M, class Other>
inline M either(const M& a, const Other& b) {
  if constexpr (std::is_same_v<M, bool>)
    return a || b();
  else
    return a | b();
}

}  // namespace tamis
