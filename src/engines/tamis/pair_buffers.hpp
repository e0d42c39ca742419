// What both pipelines ask of the kernels' buffers and of the counts of pairs.
#pragma once
#include "engines/pair_rules.hpp"
#include "kernels/kernels.hpp"
#include "tamis/statistics.hpp"

namespace tamis {

inline std::uint64_t& of(StageCount& count, PairKind kind) {
  return kind == PairKind::vertex_face ? count.vf : count.ee;
}

/// In contact order: the search gives them so.
inline PairVertices vertices_of(const PairBuffer& pairs, int i) {
  return {pairs.corner[0][i], pairs.corner[1][i], pairs.corner[2][i], pairs.corner[3][i]};
}

}  // namespace tamis
