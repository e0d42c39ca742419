#include "search/engine/stages.hpp"

namespace tamis {
namespace {

/// The slab clip, from thread.boxes to thread.clipped.
void clip(SearchThread& thread, PairKind kind, const PairKernels& stages) {
  const auto entered = static_cast<std::uint64_t>(thread.boxes.count);
  of(thread.counts.boxes, kind) += entered;
  of(thread.counts.slab, kind) += entered;
  stages.slab(thread.motion.view(), thread.boxes, thread.clipped);
}

}  // namespace

void filter_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages) {
  clip(thread, kind, stages);
  of(thread.counts.dnf, kind) += static_cast<std::uint64_t>(thread.clipped.count);
  of(thread.counts.ncf, kind) +=
      static_cast<std::uint64_t>(stages.filter(thread.motion.view(), thread.clipped, thread.filtered));
  of(thread.counts.solve, kind) += static_cast<std::uint64_t>(thread.filtered.count);
  thread.counts.filter += thread.watch.lap();
}

int decide_crossings(SearchThread& thread, PairKind kind, const PairKernels& stages) {
  filter_crossings(thread, kind, stages);
  return stages.solve(thread.motion.view(), thread.filtered, thread.clipped, thread.solved_scratch());
}

int decide_within_separation(SearchThread& thread, PairKind kind, double latest) {
  const PairKernels& stages = thread.kernels.of(kind);
  const MotionView motion = thread.motion.view();
  clip(thread, kind, stages);
  of(thread.counts.apart, kind) += static_cast<std::uint64_t>(thread.clipped.count);
  stages.cull_apart(motion, thread.clipped, thread.filtered);
  of(thread.counts.solve, kind) += static_cast<std::uint64_t>(thread.filtered.count);
  thread.counts.filter += thread.watch.lap();
  return stages.come_within(motion, latest, thread.filtered, thread.within_scratch(), thread.solved_scratch());
}

}  // namespace tamis
