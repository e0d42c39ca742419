// Kernels that are compiled in sources of their own, decide_isa.cpp and cull_apart_isa.cpp: see PairKernels.
#pragma once
#include "search/kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind>
void decide(const MotionView& motion, double latest, const PairBuffer& in, DecisionScratch& scratch,
            LaneDecisions& out);
void decide_along_edges(const MotionView& motion, double latest, const PairBuffer& in, DecisionScratch& scratch,
                        LaneDecisions& out);
template <PairKind kind>
void decide_rows(const StepRows& vertices, double min_separation, double latest, const PairBuffer& in,
                 DecisionScratch& scratch, LaneDecisions& out);
template <PairKind kind>
void cull_apart(const MotionView& motion, PairBuffer& pairs, PairBuffer& out);

}  // namespace tamis::TAMIS_ISA
