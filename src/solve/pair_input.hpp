// What callers of single pairs, and of lists of them, may give.
#pragma once
#include <string>

#include "tamis/pair.hpp"

namespace tamis {

/// Throws InvalidOptions unless the separation is finite and >= 0 and the guarantee has a name.
void validate(const PairOptions& options);

/// The sentence on a point of a pair. `when`: "start" or "end".
std::string not_finite(std::size_t point, const char* when);

/// x - x is 0 for finite x, NaN otherwise: one test for the three.
inline bool is_finite(const double* p) { return p[0] - p[0] + (p[1] - p[1]) + (p[2] - p[2]) == 0; }

}  // namespace tamis
