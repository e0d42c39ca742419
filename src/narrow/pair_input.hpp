// What callers of single pairs, and of lists of them, may give.
#pragma once
#include <string>

#include "tamis/pair.hpp"

namespace tamis {

/// Throws InvalidOptions unless the separation is finite and >= 0 and the latest time lies in [0,1].
void validate(const PairOptions& options);

/// The sentence on a point of a pair. `when`: "start" or "end".
std::string not_finite(std::size_t point, const char* when);

}  // namespace tamis
