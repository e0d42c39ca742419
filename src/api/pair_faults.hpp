// Sentences about pairs: their features, and the faults that a pair which names rows of a step may have.
#pragma once
#include <string>

#include "tamis/pair.hpp"

namespace tamis {

/// "vertex 3 and face 0 1 2". Vertices as in Contact. REQUIRES: `kind` is a PairKind.
std::string features_text(PairKind kind, const std::array<Index, 4>& vertices);
/// The sentence on a number that is not a PairKind.
std::string no_such_kind(PairKind kind);
/// The sentence on a point of a pair. `when`: "start" or "end".
std::string not_finite(std::size_t point, const char* when);
/// The sentence on one pair; empty if nothing is wrong with it.
std::string fault_of(const FeaturePair& pair, const Step& step);

}  // namespace tamis
