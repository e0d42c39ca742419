// What differs between the commits that the matrix is built against.
#pragma once
#include <cstdint>

#include "tamis/statistics.hpp"

namespace tamis::matrix {

/// Of all kinds that this version counts.
template <class Stage>
std::uint64_t pairs_of(const Stage& stage) {
  if constexpr (requires { stage.ve; })
    return stage.vf + stage.ee + stage.ve + stage.vv;
  else
    return stage.vf + stage.ee;
}

/// Every pair is decided, in versions that leave the choice, too.
template <class AnyOptions>
void decide_all(AnyOptions& options) {
  if constexpr (requires { options.guarantee; }) options.guarantee = decltype(options.guarantee)::exact;
}

/// By the name that this version has for it.
template <class AnyDetector, class AnyStep>
auto safe_step(AnyDetector& detector, const AnyStep& step, double keep) {
  if constexpr (requires { detector.safe_step(step, keep); })
    return detector.safe_step(step, keep);
  else
    return detector.keep_distance(step, keep);
}

}  // namespace tamis::matrix
