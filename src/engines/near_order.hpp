// The documented order of pairs at rest.
#pragma once
#include <vector>

#include "engines/pair_rules.hpp"

namespace tamis {

/// Sorts pairs of one kind by their vertices; keeps its scratch memory from call to call.
class NearOrder {
 public:
  void sort(std::vector<PairVertices>& pairs, Index vertex_count);
  std::uint64_t memory_bytes() const {
    return first_.capacity() * sizeof(first_[0]) + sorted_.capacity() * sizeof(PairVertices);
  }

 private:
  std::vector<std::uint32_t> first_;  ///< of each first vertex
  std::vector<PairVertices> sorted_;
};

}  // namespace tamis
