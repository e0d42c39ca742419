// The pairs of a list, in lanes: see Kernels::settle.
#pragma once
#include "kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

int settle_vf(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results, std::int32_t* open);
int settle_ee(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results, std::int32_t* open);
int settle_ve(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results, std::int32_t* open);
int settle_vv(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results, std::int32_t* open);

}  // namespace tamis::TAMIS_ISA
