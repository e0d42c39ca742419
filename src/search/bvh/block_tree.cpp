#include "search/bvh/block_tree.hpp"

#include <algorithm>

#include "numbers/assert.hpp"
#include "numbers/in_parts.hpp"

namespace tamis {
namespace {

std::size_t blocks_for(std::size_t items) { return (items + kBlock - 1) / kBlock; }

template <class F>
void parallel_blocks(std::size_t count, const F& f) {
  constexpr std::size_t kGrain = 256;
  in_parts(count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) f(i);
  });
}

/// Empties the last block, which may stay partly unfilled; the others are not initialized.
RawArray<BoxBlock> new_blocks(std::size_t count) {
  RawArray<BoxBlock> blocks(count);
  for (int lane = 0; lane < kBlock && count > 0; ++lane) MovingBox().store_to(blocks[count - 1], lane);
  return blocks;
}

}  // namespace

void BlockTree::set_features(std::span<const Index> points) {
  corners_ = 1;
  vertices_ = points;
}

void BlockTree::set_groups(std::span<const Index> group_of_vertex, std::span<const std::uint8_t> may_touch,
                           Index group_count) {
  group_of_vertex_ = group_of_vertex;
  groups_.may_touch = group_of_vertex.empty() || may_touch.empty() ? nullptr : may_touch.data();
  groups_.group_count = group_count;
  const auto count = static_cast<std::size_t>(group_count);
  no_self_contact_.assign(groups_.may_touch ? count : 0, 0);
  for (std::size_t group = 0; group < no_self_contact_.size(); ++group)
    no_self_contact_[group] = !may_touch[group * count + group];
}

void BlockTree::build(const PackedMotion& motion, const OrderAxes& by, BoundLeaf bound_leaf, const Pause& pause) {
  is_built_ = false;
  levels_.clear();
  residuals_.clear();
  for (std::size_t blocks = blocks_for(static_cast<std::size_t>(feature_count()));; blocks = blocks_for(blocks)) {
    levels_.push_back(new_blocks(blocks));
    if (blocks <= 1 && levels_.size() > 1) break;
  }
  corner_blocks_ = RawArray<CornerBlock>(levels_[0].size());
  by.count() == 3 ? choose_order<3>(motion, by, pause) : choose_order<6>(motion, by, pause);
  if (groups_.may_touch) group_blocks();
  is_built_ = true;
  refit(motion, bound_leaf);
}

void BlockTree::group_blocks() {
  std::vector<Index> below;  // groups of features, then of the blocks of each level
  for (const CornerBlock& block : corner_blocks_.all())
    for (const Index vertex : block.vertex[0])  // empty lanes repeat a feature of the block
      below.push_back(group_of_vertex_[static_cast<std::size_t>(vertex)]);
  group_of_block_.clear();
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    std::vector<Index> groups;
    for (std::size_t child = 0; child < below.size(); ++child)
      if (child % kBlock == 0)
        groups.push_back(below[child]);
      else if (groups.back() != below[child])
        groups.back() = BlockGroups::kMixed;
    group_of_block_.push_back(groups);
    below = std::move(groups);
  }
}

GroupOrder BlockTree::order_groups(const PackedMotion& motion) const {
  std::vector<GroupedFeature> features(static_cast<std::size_t>(feature_count()));
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(vertex_of(static_cast<Index>(i), 0));
    features[i] = {group_of_vertex_[vertex], motion.box_vertices[vertex].at};
  }
  return tamis::order_groups(features, no_self_contact_);
}

template <int axes>
void BlockTree::choose_order(const PackedMotion& motion, const OrderAxes& by, const Pause& pause) {
  const auto n = static_cast<std::size_t>(feature_count()), corners = static_cast<std::size_t>(corners_);
  RawArray<Center<axes>> store(n);
  const std::span centers(store.data(), n);
  const GroupOrder groups = separates_groups() ? order_groups(motion) : GroupOrder();
  parallel_blocks(blocks_for(n), [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) {
      const Index feature = groups.features.empty() ? static_cast<Index>(i) : groups.features[i];
      float sum[6] = {};
      for (std::size_t c = 0; c < corners; ++c) {
        const auto& at = motion.box_vertices[static_cast<std::size_t>(vertex_of(feature, c))].at;
        for (int k = 0; k < 6; ++k) sum[k] += at[k];
      }
      centers[i] = by.center<axes>(sum, static_cast<float>(corners_), feature);
    }
  });
  pause();
  order_in_space(centers, pause, groups.ends);
  parallel_blocks(corner_blocks_.size(), [&](std::size_t block) {
    const std::size_t first = block * kBlock;
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      const std::size_t slot = first + lane < n ? first + lane : first;
      for (std::size_t c = 0; c < 3; ++c)
        corner_blocks_[block].vertex[c][lane] = vertex_of(centers[slot].feature, std::min(c, corners - 1));
    }
  });
}

void BlockTree::refit(const PackedMotion& motion, BoundLeaf bound_leaf) {
  TAMIS_ASSERT(is_built_);
  fill(levels_, motion.box_vertices, {motion.frame.margin, 0}, bound_leaf);
}

void BlockTree::refit_residuals(const PackedMotion& motion, BoundLeaf bound_leaf) {
  TAMIS_ASSERT(is_built_ && motion.residuals.size() == motion.box_vertices.size());
  if (residuals_.size() != levels_.size()) {
    residuals_.clear();
    for (const auto& level : levels_) residuals_.push_back(new_blocks(level.size()));
  }
  fill(residuals_, motion.residuals, {BoxFrame::kLeastMargin, BoxFrame::kRelativeMargin}, bound_leaf);
}

void BlockTree::fill(Levels& levels, const std::vector<BoxVertex>& vertices, const BoxMargins& margins,
                     BoundLeaf bound_leaf) const {
  parallel_blocks(corner_blocks_.size(), [&](std::size_t block) {
    MovingBox hull;
    const auto in_use = std::min<std::size_t>(static_cast<std::size_t>(feature_count()) - block * kBlock, kBlock);
    bound_leaf(vertices.data(), corner_blocks_[block], corners_, static_cast<int>(in_use), margins, levels[0][block],
               hull);
    hull.store_to(levels[1][block / kBlock], static_cast<int>(block % kBlock));
  });
  for (std::size_t level = 2; level < levels.size(); ++level)
    parallel_blocks(levels[level - 1].size(), [&](std::size_t child) {
      MovingBox hull;
      for (int lane = 0; lane < kBlock; ++lane) hull.include({levels[level - 1][child], lane});
      hull.store_to(levels[level][child / kBlock], static_cast<int>(child % kBlock));
    });
}

void BlockTree::mark(std::span<const std::uint8_t> of_vertex) {
  marked_.clear();
  if (of_vertex.empty()) return;
  TAMIS_ASSERT(is_built_);
  const auto is_marked = [&](const CornerBlock& block) {
    return std::ranges::any_of(block.vertex, [&](const auto& corner) {
      return std::ranges::any_of(corner, [&](Index v) { return of_vertex[static_cast<std::size_t>(v)] != 0; });
    });
  };
  std::vector<std::uint8_t> marks(corner_blocks_.size());
  parallel_blocks(marks.size(), [&](std::size_t block) { marks[block] = is_marked(corner_blocks_[block]); });
  for (marked_.push_back(std::move(marks)); marked_.size() < levels_.size();) {
    const std::vector<std::uint8_t>& below = marked_.back();
    std::vector<std::uint8_t> above(blocks_for(below.size()));
    for (std::size_t child = 0; child < below.size(); ++child) above[child / kBlock] |= below[child];
    marked_.push_back(std::move(above));
  }
}

TreeView BlockTree::view() const {
  TreeView view{};
  for (const auto& level : residuals_) view.residuals[view.level_count++] = level.data();
  view.level_count = 0;
  for (const auto& level : levels_) view.levels[view.level_count++] = level.data();
  view.leaf_blocks = static_cast<int>(corner_blocks_.size());
  view.corners = corner_blocks_.data();
  view.groups = groups_;
  for (std::size_t level = 0; level < group_of_block_.size(); ++level)
    view.groups.of[level] = group_of_block_[level].data();
  for (std::size_t level = 0; level < marked_.size(); ++level) view.marked[level] = marked_[level].data();
  view.has_exclusions = groups_.may_touch || !marked_.empty();
  return view;
}

BlockTree::Areas BlockTree::areas() const {
  Areas sum;
  for (std::size_t block = 0; block < corner_blocks_.size(); ++block) {
    const BoxBlock& hulls = levels_[1][block / kBlock];
    const std::size_t lane = block % kBlock;
    float size[3], swept[3];
    for (int axis = 0; axis < 3; ++axis) {
      const float low = hulls.low0[axis][lane], high = hulls.high0[axis][lane];
      size[axis] = high - low;
      swept[axis] = std::max(high, hulls.high1[axis][lane]) - std::min(low, hulls.low1[axis][lane]);
    }
    if (*std::ranges::max_element(swept) > kWidest) continue;
    const auto half_area = [](const float(&box)[3]) {
      return static_cast<double>(box[0] * box[1] + box[1] * box[2] + box[2] * box[0]);
    };
    sum.at_start += half_area(size);
    sum.swept += half_area(swept);
  }
  return sum;
}

}  // namespace tamis
