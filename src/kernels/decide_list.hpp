// The pairs of a list, in lanes: see PairKernels::decide_list.
#pragma once
#include "kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind>
int decide_list(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
                std::int32_t* undecided);

}  // namespace tamis::TAMIS_ISA
