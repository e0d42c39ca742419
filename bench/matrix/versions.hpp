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

}  // namespace tamis::matrix
