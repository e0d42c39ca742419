// Pairs within a separation: see PairKernels::cull_apart and come_within.
#pragma once
#include "kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind>
void cull_apart(const BoxVertex* vertices, const BoxSeparation& separation, PairBuffer& pairs, PairBuffer& out);
template <PairKind kind>
int come_within(const PackedVertex* vertices, const WithinRule& rule, const PairBuffer& in, WithinScratch& scratch,
                SolvedPair* out);

}  // namespace tamis::TAMIS_ISA
