// The pairs of a list, in lanes: see PairKernels::settle.
#pragma once
#include "kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind>
int settle(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results, std::int32_t* open);

}  // namespace tamis::TAMIS_ISA
