// Decides pairs in lanes. Compiled once for each instruction set. decide() runs the same tests on a pair, in the same
// order. So a pair has the same bits wherever and with whatever other pairs it is decided.
#include "search/kernels/advance_lanes.hpp"
#include "search/kernels/crossing_lanes.hpp"
#include "search/kernels/isa_declarations.hpp"

namespace tamis::TAMIS_ISA {
namespace {

template <PairKind kind, Course course = Course::step, class Vertices>
void decide_in_lanes(Vertices vertices, const PairSeparation<double>& separation, double latest, const PairBuffer& in,
                     DecisionScratch& scratch, LaneDecisions& out) {
  out.touching_count = out.undecided_count = 0;
  if constexpr (can_cross(kind))
    if (separation.fixed == 0 && !separation.has_radii)
      return CrossingLanes<kind, course, Vertices>(vertices, latest, scratch.moving, out).run(in);
  if constexpr (course == Course::step)
    AdvanceLanes<kind, Vertices>(vertices, separation, latest, scratch, out).run(in);
}

}  // namespace

template <PairKind kind>
void decide(const MotionView& motion, double latest, const PairBuffer& in, DecisionScratch& scratch,
            LaneDecisions& out) {
  decide_in_lanes<kind>(motion.vertices, motion.separation, latest, in, scratch, out);
}

template <PairKind kind>
void decide_rows(const StepRows& vertices, double min_separation, double latest, const PairBuffer& in,
                 DecisionScratch& scratch, LaneDecisions& out) {
  decide_in_lanes<kind>(vertices, {min_separation, false}, latest, in, scratch, out);
}

void decide_along_edges(const MotionView& motion, double latest, const PairBuffer& in, DecisionScratch& scratch,
                        LaneDecisions& out) {
  decide_in_lanes<PairKind::vertex_face, Course::along_edge>(motion.vertices, {}, latest, in, scratch, out);
}

#define TAMIS_DECIDE(kind)                                                                                        \
  template void decide<PairKind::kind>(const MotionView&, double, const PairBuffer&, DecisionScratch&,            \
                                       LaneDecisions&);                                                           \
  template void decide_rows<PairKind::kind>(const StepRows&, double, double, const PairBuffer&, DecisionScratch&, \
                                            LaneDecisions&);
TAMIS_DECIDE(vertex_face)
TAMIS_DECIDE(edge_edge)
TAMIS_DECIDE(vertex_edge)
TAMIS_DECIDE(vertex_vertex)
#undef TAMIS_DECIDE

}  // namespace tamis::TAMIS_ISA
