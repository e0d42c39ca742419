// Kernels that are compiled in sources of their own, decide_list_isa.cpp and within_isa.cpp: see PairKernels.
#pragma once
#include "search/kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind>
int decide_list(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
                std::int32_t* undecided);
template <PairKind kind>
void cull_apart(const MotionView& motion, PairBuffer& pairs, PairBuffer& out);
template <PairKind kind>
int come_within(const MotionView& motion, double latest, const PairBuffer& in, WithinScratch& scratch, SolvedPair* out);

}  // namespace tamis::TAMIS_ISA
