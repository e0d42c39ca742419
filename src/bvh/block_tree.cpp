#include "bvh/block_tree.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace tamis {
namespace {

std::size_t blocks_for(std::size_t items) { return (items + kBlock - 1) / kBlock; }

template <class F>
void parallel_blocks(std::size_t count, const F& f) {
  constexpr std::size_t kGrain = 256;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) f(i);
  });
}

/// Lane of `to` becomes the hull of all lanes of `from`.
void put_hull(const BoxBlock& from, BoxBlock& to, int lane) {
  for (int axis = 0; axis < 3; ++axis) {
    to.low0[axis][lane] = *std::min_element(from.low0[axis], from.low0[axis] + kBlock);
    to.low1[axis][lane] = *std::min_element(from.low1[axis], from.low1[axis] + kBlock);
    to.high0[axis][lane] = *std::max_element(from.high0[axis], from.high0[axis] + kBlock);
    to.high1[axis][lane] = *std::max_element(from.high1[axis], from.high1[axis] + kBlock);
  }
}

}  // namespace

void BlockTree::set_features(int corners, std::span<const Index> vertices) {
  corners_ = corners;
  vertices_ = vertices;
}

void BlockTree::build(const PackedMotion& motion) {
  const auto n = static_cast<std::size_t>(feature_count()), corners = static_cast<std::size_t>(corners_);
  std::vector<std::array<float, 3>> centers(n);
  parallel_blocks(blocks_for(n), [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) {
      std::array<float, 3> sum{};
      for (std::size_t c = 0; c < corners; ++c) {
        const auto& at = motion.box_vertices[static_cast<std::size_t>(vertices_[i * corners + c])].at;
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += at[axis] + at[3 + axis];
      }
      for (std::size_t axis = 0; axis < 3; ++axis) centers[i][axis] = sum[axis] / static_cast<float>(2 * corners);
    }
  });
  const std::vector<Index> slots = spatial_order(centers);

  levels_.clear();
  for (std::size_t blocks = blocks_for(n);; blocks = blocks_for(blocks)) {
    levels_.emplace_back(blocks);
    if (blocks <= 1 && levels_.size() > 1) break;
  }
  corner_blocks_.resize(levels_[0].size());
  for (std::size_t slot = 0; slot < corner_blocks_.size() * kBlock; ++slot)
    for (std::size_t c = 0; c < 3; ++c)
      corner_blocks_[slot / kBlock].vertex[c][slot % kBlock] =
          slot < n && c < corners ? vertices_[static_cast<std::size_t>(slots[slot]) * corners + c] : -1;
  refit(motion);
}

void BlockTree::refit(const PackedMotion& motion) {
  parallel_blocks(levels_[0].size(), [&](std::size_t block) { fill_leaf(block, motion); });
  for (std::size_t level = 1; level < levels_.size(); ++level) fill_hulls(level);
}

void BlockTree::fill_leaf(std::size_t block, const PackedMotion& motion) {
  BoxBlock& boxes = levels_[0][block];
  const CornerBlock& corners = corner_blocks_[block];
  const float margin = motion.frame.margin;
  for (int lane = 0; lane < kBlock; ++lane) {
    boxes.clear(lane);
    for (int c = 0; c < corners_ && corners.vertex[c][lane] >= 0; ++c) {
      const auto& at = motion.box_vertices[static_cast<std::size_t>(corners.vertex[c][lane])].at;
      for (int axis = 0; axis < 3; ++axis) {
        boxes.low0[axis][lane] = std::min(boxes.low0[axis][lane], at[axis] - margin);
        boxes.high0[axis][lane] = std::max(boxes.high0[axis][lane], at[axis] + margin);
        boxes.low1[axis][lane] = std::min(boxes.low1[axis][lane], at[3 + axis] - margin);
        boxes.high1[axis][lane] = std::max(boxes.high1[axis][lane], at[3 + axis] + margin);
      }
    }
  }
}

void BlockTree::fill_hulls(std::size_t level) {
  const auto& below = levels_[level - 1];
  parallel_blocks(levels_[level].size(), [&](std::size_t block) {
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      const std::size_t child = block * kBlock + lane;
      if (child < below.size())
        put_hull(below[child], levels_[level][block], static_cast<int>(lane));
      else
        levels_[level][block].clear(static_cast<int>(lane));
    }
  });
}

TreeView BlockTree::view() const {
  TreeView view{};
  for (const auto& level : levels_) view.levels[view.level_count++] = level.data();
  view.leaf_blocks = static_cast<int>(corner_blocks_.size());
  view.corners = corner_blocks_.data();
  return view;
}

double BlockTree::swept_area() const {
  double area = 0;
  for (const BoxBlock& hulls : levels_[1])
    for (int lane = 0; lane < kBlock; ++lane) {
      float size[3];
      for (int axis = 0; axis < 3; ++axis)
        size[axis] = std::max(0.0f, std::max(hulls.high0[axis][lane], hulls.high1[axis][lane]) -
                                        std::min(hulls.low0[axis][lane], hulls.low1[axis][lane]));
      area += static_cast<double>(size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
    }
  return area;
}

std::uint64_t BlockTree::memory_bytes() const {
  std::uint64_t bytes = corner_blocks_.capacity() * sizeof(CornerBlock);
  for (const auto& level : levels_) bytes += level.capacity() * sizeof(BoxBlock);
  return bytes;
}

}  // namespace tamis
