#include "solve/exact.hpp"
#include "tamis/error.hpp"

namespace tamis {
ExactDecision decide_exactly(PairKind, const PairPoints&) { throw InvalidOptions("exact is not built yet"); }
}  // namespace tamis
