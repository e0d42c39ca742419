// What may be wrong with a pair that names rows of a step.
#pragma once
#include <string>

#include "tamis/pair.hpp"

namespace tamis {

/// The sentence on a kind that is none.
std::string no_such_kind(PairKind kind);
/// The sentence on one pair; empty if nothing is wrong with it.
std::string fault_of(const Pair& pair, const Step& step);

}  // namespace tamis
