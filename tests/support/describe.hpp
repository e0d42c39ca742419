// A pair of features as text, for failure messages.
#pragma once
#include <string>

#include "oracle/oracle.hpp"

namespace tamis::test {

/// Coordinates in hexadecimal, to reproduce a failure exactly.
std::string describe(PairKind kind, const oracle::Motion& motion);

}  // namespace tamis::test
