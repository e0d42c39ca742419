// What a filter is: a stateless struct with a name and one certificate over pairs of features.
//
//   struct Example {
//     static constexpr std::string_view name = "example";
//     template <PairKind kind, class T>
//     static Mask<T> proves_free(const PairMotion<T>& m);
//   };
//
// `proves_free` is true only where the pair is proven apart during the whole of the (possibly restricted) motion,
// rounding included; NaN and infinity must come out false. T is double, or SIMD lanes of it.
#pragma once
#include <string_view>
#include <utility>

#include "motion/pair_motion.hpp"
#include "numerics/error_bounds.hpp"

namespace tamis {

/// Result of a comparison: bool for double, a lane mask for SIMD lanes.
template <class T>
using Mask = decltype(std::declval<T>() > std::declval<T>());

}  // namespace tamis
