#include "search/candidate_consumer.hpp"

namespace tamis {

void CandidateConsumer::begin(CandidateQuery& asked) {
  PairConsumer::begin(asked.query);
  asked_ = &asked;
  release();  // an exception may have left pairs of another query
}

/// The slab clip, then DNF where contact means a crossing. With a separation axes that turn: strict signs prove no
/// distance.
void CandidateConsumer::consume(PairKind kind) {
  PairBuffer &boxes = thread().boxes, &clipped = thread().clipped, &filtered = thread().filtered;
  const PackedMotion& motion = thread().motion;
  const PairKernels& stages = thread().kernels.of(kind);
  clipped.count = filtered.count = 0;
  stages.slab(motion.box_vertices.data(), motion.box_separation(), boxes, clipped);
  if (can_cross(kind) && !query().separations.any())
    stages.filter_deviating(motion.vertices.data(), asked_->deviation, clipped, filtered);
  else
    stages.cull_apart(motion.box_vertices.data(), motion.box_separation(), clipped, filtered);
  candidates(kind).append(filtered, vertex_count(kind));
  if (asked_->left.fetch_sub(filtered.count, std::memory_order_relaxed) < filtered.count) asked_->bound.settle();
}

std::uint64_t CandidateConsumer::memory_bytes() const {
  std::uint64_t bytes = 0;
  for (const PairList& pairs : candidates_) bytes += pairs.memory_bytes();
  return bytes;
}

}  // namespace tamis
