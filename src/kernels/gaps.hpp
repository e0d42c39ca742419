// The kernels that measure gaps, which stand in a file of their own.
#pragma once
#include "kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

/// As Kernels has them.
float gap_vf(const GapQuestion& question, int block, int other, float most, PairBuffer& scratch);
float gap_ee(const GapQuestion& question, int block, int other, float most, PairBuffer& scratch);
unsigned near_hulls(const BoxBlock& hulls, const BoxBlock& of, int lane, float reach, HullGaps& found);
int unproven(const GapScan& scan, std::int32_t* out);

}  // namespace tamis::TAMIS_ISA
