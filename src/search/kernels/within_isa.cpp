// Kernels for pairs with a separation; compiled once for each instruction set.
#include "pair/distance/turning_gap.hpp"
#include "search/kernels/advance_lanes.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/isa_declarations.hpp"

namespace tamis::TAMIS_ISA {
namespace {

/// Culls pairs by one axis that turns in each of `parts` parts of their times. In floats: culling need not be sharp,
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

/// The sink of AdvanceLanes that lists pairs that touch or are undecided.
struct SolvedSink {
  void free(std::int32_t) {}
  void undecided(std::int32_t place) { out[count++] = {place, false, {}}; }
  void touches(std::int32_t place, const ContactLanes& contacts, int lane) {
    out[count++] = {place, true, contacts.result(lane)};
  }

  SolvedPair* out;
  int count = 0;
};

}  // namespace

template <PairKind kind>
void cull_apart(const MotionView& motion, PairBuffer& pairs, PairBuffer& out) {
  pairs.count = cull_in_parts<kind>(1, motion, pairs, pairs);
  out.count = cull_in_parts<kind>(kTurningGapParts, motion, pairs, out);
}

template <PairKind kind>
int come_within(const MotionView& motion, double latest, const PairBuffer& in, WithinScratch& scratch,
                SolvedPair* out) {
  SolvedSink sink{out};
  AdvanceLanes<kind, const PackedVertex*, SolvedSink>(motion.vertices, motion.separation, latest, scratch, sink)
      .run(in);
  return sink.count;
}

#define TAMIS_WITHIN(kind)                                                               \
  template void cull_apart<PairKind::kind>(const MotionView&, PairBuffer&, PairBuffer&); \
  template int come_within<PairKind::kind>(const MotionView&, double, const PairBuffer&, WithinScratch&, SolvedPair*);
TAMIS_WITHIN(vertex_face)
TAMIS_WITHIN(edge_edge)
TAMIS_WITHIN(vertex_edge)
TAMIS_WITHIN(vertex_vertex)
#undef TAMIS_WITHIN

}  // namespace tamis::TAMIS_ISA
