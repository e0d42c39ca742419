#include "search/engine/stages.hpp"

namespace tamis {
namespace {

const PairBuffer& clip(SearchThread& thread, PairKind kind, const PairKernels& stages, const PairBuffer& pairs) {
  const auto entered = static_cast<std::uint64_t>(pairs.count);
  of(thread.counts.boxes, kind) += entered;
  of(thread.counts.slab, kind) += entered;
  stages.slab(thread.motion.view(), pairs, thread.clipped);
  return thread.clipped;
}

}  // namespace

const PairBuffer& filter_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages,
                                   const PairBuffer& pairs) {
  const PairBuffer& clipped = clip(thread, kind, stages, pairs);
  PairBuffer& left = thread.filtered;
  of(thread.counts.dnf, kind) += static_cast<std::uint64_t>(clipped.count);
  of(thread.counts.ncf, kind) += static_cast<std::uint64_t>(stages.filter(thread.motion.view(), clipped, left));
  of(thread.counts.solve, kind) += static_cast<std::uint64_t>(left.count);
  thread.counts.filter += thread.watch.lap();
  return left;
}

const PairBuffer& filter_apart(SearchThread& thread, PairKind kind, const PairKernels& stages,
                               const PairBuffer& pairs) {
  clip(thread, kind, stages, pairs);
  PairBuffer &clipped = thread.clipped, &left = thread.filtered;
  of(thread.counts.apart, kind) += static_cast<std::uint64_t>(clipped.count);
  stages.cull_apart(thread.motion.view(), clipped, left);
  of(thread.counts.solve, kind) += static_cast<std::uint64_t>(left.count);
  thread.counts.filter += thread.watch.lap();
  return left;
}

LaneDecisions decide_in_lanes(SearchThread& thread, const PairKernels& stages, double latest, const PairBuffer& pairs) {
  TAMIS_ASSERT(0 <= pairs.count && pairs.count <= PairBuffer::kCapacity);
  LaneDecisions decisions = thread.decision_lists();
  stages.decide(thread.motion.view(), latest, pairs, thread.decision_scratch(), decisions);
  thread.counts.decided_by.lanes += static_cast<std::uint64_t>(pairs.count - decisions.undecided_count);
  return decisions;
}

}  // namespace tamis
