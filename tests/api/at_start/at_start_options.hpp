// Options of questions that ignore pairs touching at the start, or fail because of them.
#pragma once
#include "tamis/options.hpp"

namespace tamis::test {

inline constexpr QueryOptions kIgnore{.at_start = AtStart::ignore}, kFail{.at_start = AtStart::fail};
inline constexpr PathOptions kIgnoreOnPath{.at_start = AtStart::ignore}, kFailOnPath{.at_start = AtStart::fail};

}  // namespace tamis::test
