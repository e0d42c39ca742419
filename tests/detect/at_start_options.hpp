// Questions that ignore pairs that touch at the start, or refuse them.
#pragma once
#include "tamis/options.hpp"

namespace tamis::test {

inline constexpr QueryOptions kIgnore{.at_start = AtStart::ignore}, kFail{.at_start = AtStart::fail};

}  // namespace tamis::test
