#include "engines/tamis/gap_memory.hpp"

#include <algorithm>
#include <cmath>

namespace tamis {
namespace {

/// Blocks are listed that are nearer than this part of their mean extent. Longer lists take longer to go through, and
/// serve farther.
constexpr double kReach = 0.25;
/// A question follows the last one if its start is nearer than this many times the edges' length.
constexpr double kFollows = 0.25;
/// Lists of which so much has to be looked at are of no use for a while.
constexpr double kUseless = 0.5;
constexpr int kPause = 16;
constexpr int kWorthwhile = 3;

void copy(const Positions& from, std::span<const Index> used, std::vector<Point>& to) {
  to.resize(static_cast<std::size_t>(from.count()));
  for (Index v : used) std::copy_n(from[v], 3, to[static_cast<std::size_t>(v)].begin());
}

/// The mean, over a tree's leaf blocks, of the largest side of their hull at t=0.
double mean_extent(const TreeView& tree) {
  double sum = 0;
  for (int block = 0; block < tree.leaf_blocks; ++block) {
    const BoxBlock& hulls = tree.levels[1][block / kBlock];
    float extent = 0;
    for (int axis = 0; axis < 3; ++axis)
      extent = std::max(extent, hulls.high0[axis][block % kBlock] - hulls.low0[axis][block % kBlock]);
    sum += static_cast<double>(extent);
  }
  return tree.leaf_blocks > 0 ? sum / tree.leaf_blocks : 0;
}

/// How far any two vertices have moved against each other, at most, until t. `tree` is that of all points.
float drift_of_all(const TreeView& tree, float t) {
  if (tree.leaf_blocks == 0) return 0;
  const BoxBlock& root = tree.drifts[tree.level_count - 1][0];
  MovingBox all;
  for (int lane = 0; lane < kBlock; ++lane) all.include({root, lane});
  float squares[2] = {};
  for (int i = 0; i < 6; ++i) squares[i / 3] += (all.high[i] - all.low[i]) * (all.high[i] - all.low[i]);
  const float start = std::sqrt(squares[0]), end = std::sqrt(squares[1]);
  return std::max(start, start + t * (end - start));
}

}  // namespace

void GapMemory::begin(const Step& step) {
  unproven_ = 0;
  follows_ = follows(step);
  copy(step.start, mesh_.points(), last_);
  const Separations& separations = trees_.motion().separations;
  const double ratio = trees_.motion().frame.scale / unit_;
  const bool holds = !where_.empty() && builds_ == trees_.builds() && follows_ && separations.radii.empty() &&
                     separations.fixed == separation_ && ratio > 0x1p-20 && ratio < 0x1p20;
  if (!holds) forget();
  serves_ = holds;
  if (!holds) return;
  scale_ = static_cast<float>(ratio);
  trees_.count_drifts(step, where_);
}

bool GapMemory::covers(float t) const { return drift_of_all(trees_.points(), t) < 0.99f * (reach_ * scale_); }

void GapMemory::append_unproven(PairKind kind, int block, float t, std::vector<std::int32_t>& others) {
  const std::size_t before = others.size();
  if (kind == PairKind::vertex_face)
    vf_.append_unproven(trees_.points(), trees_.faces(), block, t, scale_, others);
  else
    ee_.append_unproven(trees_.edges(), trees_.edges(), block, t, scale_, others);
  unproven_.fetch_add(others.size() - before, std::memory_order_relaxed);
}

void GapMemory::end(const Step& step, float t) {
  if (!follows_ || !trees_.motion().separations.radii.empty()) return;
  if (pause_ > 0) {
    --pause_;
    return;
  }
  const std::size_t unproven = unproven_, all = vf_.size() + ee_.size();
  if (serves_ && covers(t)) {
    if (static_cast<double>(unproven) > kUseless * static_cast<double>(all)) return give_up();
    if (most_unproven_ == 0) most_unproven_ = std::max(2 * unproven, all / 8);
    ++served_;
    if (unproven <= most_unproven_) return;
  }
  // Making lists costs as much as a question: they must have saved some.
  if (!where_.empty() && served_ < kWorthwhile) return give_up();
  if (starts_again_) remember(step, t);
}

void GapMemory::give_up() {
  forget();
  pause_ = kPause;
}

bool GapMemory::follows(const Step& step) {
  if (last_.empty()) return false;
  constexpr std::size_t kSample = 4096;
  double moved = 0, size = 0;
  const auto edges = mesh_.edges();
  for (std::size_t e = 0; e < edges.size(); e += 1 + edges.size() / kSample)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto v = static_cast<std::size_t>(edges[e][0]);
      moved += std::fabs(step.start[edges[e][0]][axis] - last_[v][axis]);
      size += std::fabs(step.start[edges[e][1]][axis] - step.start[edges[e][0]][axis]);
    }
  starts_again_ = moved == 0;
  return moved <= kFollows * size;
}

void GapMemory::remember(const Step& step, float t) {
  where_ = last_;
  trees_.count_drifts(step, where_);
  builds_ = trees_.builds();
  unit_ = trees_.motion().frame.scale;
  separation_ = trees_.motion().separations.fixed;
  most_unproven_ = 0;
  served_ = 0;
  const TreeView points = trees_.points(), edges = trees_.edges(), faces = trees_.faces();
  reach_ = static_cast<float>(kReach * std::max(mean_extent(edges), mean_extent(faces)));
  scale_ = 1;
  if (drift_of_all(points, t) > 0.5f * reach_) return give_up();
  const auto separation = static_cast<float>(separation_ * unit_ * (1 + 0x1p-20));
  const PackedVertex* vertices = trees_.motion().vertices.data();
  vf_.make({PairKind::vertex_face, kernels_, {points, faces, vertices, 1 / unit_}, reach_, separation, t});
  ee_.make({PairKind::edge_edge, kernels_, {edges, edges, vertices, 1 / unit_}, reach_, separation, t});
  const auto blocks = static_cast<std::size_t>(points.leaf_blocks) + static_cast<std::size_t>(edges.leaf_blocks);
  if (vf_.size() + ee_.size() > kMostNear * blocks) give_up();
}

void GapMemory::forget() {
  where_.clear();
  vf_.clear();
  ee_.clear();
  serves_ = false;
}

std::uint64_t GapMemory::memory_bytes() const {
  return (last_.capacity() + where_.capacity()) * sizeof(Point) + vf_.memory_bytes() + ee_.memory_bytes();
}

}  // namespace tamis
