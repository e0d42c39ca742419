// The table of all kernels of one instruction set. This file is compiled once for each.
#include "search/kernels/bound_leaf.hpp"
#include "search/kernels/clearance_boxes.hpp"
#include "search/kernels/crossing_kernels.hpp"
#include "search/kernels/isa_declarations.hpp"
#include "search/kernels/keep_boxes.hpp"
#include "search/kernels/rest_kernels.hpp"
#include "search/kernels/search.hpp"
#include "search/kernels/step_length_kernels.hpp"

namespace tamis::TAMIS_ISA {
namespace {

template <PairKind kind, class Boxes, Course course = Course::step>
void search(Search& state, int block) {
  BlockSearch<kind, Boxes, course>(state, block).run();
}

template <PairKind kind>
void search_step_ends(Search& state, int block) {
  if (moves_little(state, block))
    BlockSearch<kind, ClearanceBoxes>(state, block).run();
  else
    BlockSearch<kind, KeepBoxes>(state, block).run();
}

constexpr auto kVf = PairKind::vertex_face, kEe = PairKind::edge_edge;

template <PairKind kind>
constexpr PairKernels kernels_of() {
  constexpr PairKind kSearched = kind == kEe ? kEe : kVf;
  PairKernels kernels{.search = search<kSearched, MovingBoxes>,
                      .search_at_rest = search<kSearched, RestBoxes>,
                      .search_step_ends = search_step_ends<kSearched>,
                      .slab = slab<kind>,
                      .cull_apart = cull_apart<kind>,
                      .decide = decide<kind>,
                      .decide_rows = decide_rows<kind>,
                      .find_within_at_rest = find_within_at_rest<kind>,
                      .measure = measure<kind>};
  if constexpr (can_cross(kind)) {
    kernels.may_end_step = may_end_step<kind>;
    kernels.filter = filter<kind>;
  }
  return kernels;
}

constexpr PairKernels kAlongEdges{.search = search<kVf, RestBoxes, Course::along_edge>,
                                  .slab = slab<kVf, Course::along_edge>,
                                  .filter = filter<kVf, Course::along_edge>,
                                  .decide = decide_along_edges};

}  // namespace

static_assert(kPairKinds == 4, "name the kernels of each kind below");
extern const Kernels kKernels;
constinit const Kernels kKernels{
    Isa::TAMIS_ISA,
    bound_leaf,
    {kernels_of<kVf>(), kernels_of<kEe>(), kernels_of<PairKind::vertex_edge>(), kernels_of<PairKind::vertex_vertex>()},
    kAlongEdges};

}  // namespace tamis::TAMIS_ISA
