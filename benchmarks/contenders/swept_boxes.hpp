// For broad phases of swept boxes: the boxes, and a counter of the pairs.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "benchmarks/contenders/contender.hpp"

namespace tamis::bench {

/// Box of a feature over the whole step, rounded outward to float: the same for all contenders.
struct SweptBox {
  float low[3], high[3];
};

struct SweptBoxes {
  std::vector<SweptBox> points, edges, faces;

  void compute(const Task& task);
};

/// Counts pairs of features, given by their places in the mesh's lists, and adds up their hashes, so that two sets can
/// be compared without being stored. Leaves out pairs with a common vertex. Safe from several threads.
class PairCounter {
 public:
  explicit PairCounter(const Task& task) : mesh_(task.mesh) {}

  struct Batch {
    std::uint64_t count = 0, sum = 0;
  };
  void add_vf(std::size_t point, std::size_t face, Batch& batch) const;
  /// Edges come in either order. Leaves out a pair of an edge with itself.
  void add_ee(std::size_t a, std::size_t b, Batch& batch) const;
  void commit(PairKind kind, const Batch& batch);

  /// The answer of a broad phase: does it hold exactly the swept boxes that meet?
  Answer answer(const Task& task) const;

 private:
  const Mesh& mesh_;
  std::atomic<std::uint64_t> vf_{0}, ee_{0}, sum_{0};
};

/// Fills in the candidates of the task, by sorting along one axis and sweeping.
void find_candidates(Task& task);

}  // namespace tamis::bench
