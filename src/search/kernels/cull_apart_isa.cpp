// Culls pairs that keep their separation; compiled once for each instruction set.
#include "pair/distance/turning_gap.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/isa_declarations.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {
namespace {

/// Culls pairs by one axis that turns in each of `parts` parts of their times. In floats. Culling need not be sharp,
/// and twice as many pairs fit into the lanes. Writes the pairs left to `out`, which may be `in`; returns their number.
template <PairKind kind>
int cull_in_parts(int parts, const MotionView& motion, const PairBuffer& in, PairBuffer& out) {
  int count = 0;
  for (int first = 0; first < in.count; first += kFloatLanes) {
    const auto m = load_box_motion<kind>(motion, in, first);
    const auto time = load_time<FloatLanes>(in, first);
    const TimeInterval<FloatLanes> of_step{time.t_in, min(time.t_out, FloatLanes(1))};
    const unsigned left =
        lanes_in_use(in, first, kFloatLanes) & ~bits(TurningGap<kind, FloatLanes>(m).stays_apart(of_step, parts));
    count += store_pairs(left, in, first, time, out, count);
  }
  return count;
}

}  // namespace

template <PairKind kind>
void cull_apart(const MotionView& motion, PairBuffer& pairs, PairBuffer& out) {
  pairs.count = cull_in_parts<kind>(1, motion, pairs, pairs);
  out.count = cull_in_parts<kind>(kTurningGapParts, motion, pairs, out);
}

#define TAMIS_CULL_APART(kind) template void cull_apart<PairKind::kind>(const MotionView&, PairBuffer&, PairBuffer&)
TAMIS_CULL_APART(vertex_face);
TAMIS_CULL_APART(edge_edge);
TAMIS_CULL_APART(vertex_edge);
TAMIS_CULL_APART(vertex_vertex);
#undef TAMIS_CULL_APART

}  // namespace tamis::TAMIS_ISA
