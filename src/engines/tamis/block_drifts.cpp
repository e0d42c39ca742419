#include "engines/tamis/block_drifts.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tamis {
namespace {

/// Half of a BoxVertex; compilers do not make vector operations of these loops by themselves.
using Four = float __attribute__((vector_size(16)));

/// As much as drifts are off by, rounded to floats.
void widen(MovingBox& box) {
  for (int k = 0; k < BoxVertex::kRadius; ++k) {
    const float size = std::max(-box.low[k], box.high[k]);
    const float margin = BoxFrame::kLeastMargin + BoxFrame::kRelativeMargin * size;
    box.low[k] -= margin;
    box.high[k] += margin;
  }
}

}  // namespace

MovingBox drifts_of(const PackedMotion& motion, std::span<const Index> vertices) {
  const Four nowhere = Four{} + kNowhere;
  Four low[2] = {nowhere, nowhere}, high[2] = {-nowhere, -nowhere};
  for (const Index v : vertices) {
    Four at[2];
    std::memcpy(at, motion.drifts[static_cast<std::size_t>(v)].at, sizeof at);
    for (int half = 0; half < 2; ++half) {
      low[half] = at[half] < low[half] ? at[half] : low[half];
      high[half] = at[half] > high[half] ? at[half] : high[half];
    }
  }
  MovingBox box;
  std::memcpy(box.low, low, sizeof low);
  std::memcpy(box.high, high, sizeof high);
  widen(box);
  return box;
}

void BlockDrifts::set_blocks(const TreeView& tree, std::size_t vertex_count) {
  first_.clear();
  vertices_.clear();
  std::vector<int> last_block(vertex_count, -1);
  for (int block = 0; block < tree.leaf_blocks; ++block) {
    first_.push_back(vertices_.size());
    for (const auto& corner : tree.corners[block].vertex)
      for (const Index v : corner) {
        int& last = last_block[static_cast<std::size_t>(v)];
        if (last != block) vertices_.push_back(v);
        last = block;
      }
  }
  first_.push_back(vertices_.size());
}

void BlockDrifts::count(const PackedMotion& motion) {
  constexpr std::size_t kGrain = 256;
  const std::size_t blocks = first_.size() - 1;
  boxes_.assign(blocks, {});
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, kGrain), [&](const auto& part) {
    for (std::size_t block = part.begin(); block != part.end(); ++block) {
      const auto count = first_[block + 1] - first_[block];
      boxes_[block] = drifts_of(motion, std::span(vertices_).subspan(first_[block], count));
    }
  });
}

std::uint64_t BlockDrifts::memory_bytes() const {
  return first_.capacity() * sizeof(std::size_t) + vertices_.capacity() * sizeof(Index) +
         boxes_.capacity() * sizeof(MovingBox);
}

RelativeDrift::RelativeDrift(const MovingBox& a, const MovingBox& b) {
  float squares[2] = {};
  for (int k = 0; k < BoxVertex::kRadius; ++k) {
    const float way = std::max(a.high[k] - b.low[k], b.high[k] - a.low[k]);
    squares[k / 3] += way * way;
  }
  at_start = std::sqrt(squares[0]);
  at_end = std::sqrt(squares[1]);
}

float RelativeDrift::until(float t) const { return std::max(at_start, at_start + t * (at_end - at_start)); }

}  // namespace tamis
