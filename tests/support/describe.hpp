// A pair of features as a message shows it.
#pragma once
#include <string>

#include "oracle/oracle.hpp"

namespace tamis::test {

/// In hexadecimal, to reproduce a failure.
std::string describe(PairKind kind, const oracle::Motion& motion);

}  // namespace tamis::test
