#include "engines/tamis/gap_memory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/error_bounds.hpp"

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
/// Making lists takes as long as two or three questions: they are made when so many from one start would have been
/// served.
constexpr int kPatience = 2, kWorthwhile = 3;
/// Lists are made only if things have moved by less than this part of their reach.
constexpr float kMostDrifted = 0.5f;

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
  count_drifts(step);
}

void GapMemory::count_drifts(const Step& step) {
  all_drifts_ = drifts_of(trees_.count_vertex_drifts(step, where_), mesh_.points());
  drift_of_blocks_is_known_ = false;
}

void GapMemory::use_lists() {
  if (std::exchange(drift_of_blocks_is_known_, true)) return;
  if (drifting_builds_ != trees_.builds()) {
    const std::size_t vertices = where_.size();
    points_.set_blocks(trees_.points(), vertices);
    edges_.set_blocks(trees_.edges(), vertices);
    faces_.set_blocks(trees_.faces(), vertices);
    drifting_builds_ = trees_.builds();
  }
  for (BlockDrifts* drifts : {&points_, &edges_, &faces_}) drifts->count(trees_.motion());
}

/// How far any two vertices have moved against each other, at most, until t.
float GapMemory::drift_of_all(float t) const { return RelativeDrift(all_drifts_, all_drifts_).until(t); }

/// Gaps above this outlast the drift of any two blocks, which is no more than that of any two vertices; 2^-20 is for
/// rounding.
float GapMemory::used_up(float t) const {
  return static_cast<float>(error_bounds::kDriftWithRoom * (1 + 0x1p-20)) * drift_of_all(t);
}

bool GapMemory::covers(float t) const { return used_up(t) < reach_ * scale_; }

void GapMemory::append_unproven(PairKind kind, int block, const GapBand& band, float t,
                                std::vector<std::int32_t>& others) {
  const std::size_t before = others.size();
  const bool is_vf = kind == PairKind::vertex_face;
  const BlockDrifts &a = is_vf ? points_ : edges_, &b = is_vf ? faces_ : edges_;
  const GapScan scan{&a.boxes()[static_cast<std::size_t>(block)], b.boxes().data(), scale_, t};
  (is_vf ? vf_ : ee_)
      .append_unproven(kernels_, block, band.from * reach_, std::min(band.to * reach_, used_up(t) / scale_), scan,
                       others);
  if (others.size() > before) unproven_.fetch_add(others.size() - before, std::memory_order_relaxed);
}

void GapMemory::end(const Step& step, float t) {
  if (!follows_ || !trees_.motion().separations.radii.empty()) return;
  if (serves_ && covers(0)) {
    if (!covers(t)) return;
    const std::size_t unproven = unproven_, all = vf_.size() + ee_.size();
    if (static_cast<double>(unproven) > kUseless * static_cast<double>(all)) return give_up();
    if (most_unproven_ == 0) most_unproven_ = std::max(2 * unproven, all / 8);
    ++served_;
    if (unproven <= most_unproven_) return;
  }
  if (!starts_again_ || ++asked_again_ < kPatience) return;
  // Making lists costs as much as some questions: the last ones must have saved some.
  if (!where_.empty() && served_ < kWorthwhile) return give_up();
  remember(step, t);
}

/// In the unit of the boxes.
float GapMemory::reach_now() const {
  return static_cast<float>(kReach * std::max(mean_extent(trees_.edges()), mean_extent(trees_.faces())));
}

void GapMemory::give_up() {
  forget();
  asked_again_ = -kPause;
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
  if (!starts_again_) asked_again_ = std::min(asked_again_, 0);
  return moved <= kFollows * size;
}

void GapMemory::remember(const Step& step, float t) {
  where_ = last_;
  count_drifts(step);
  if (drift_of_all(t) > kMostDrifted * reach_now()) return forget();
  use_lists();
  builds_ = trees_.builds();
  unit_ = trees_.motion().frame.scale;
  separation_ = trees_.motion().separations.fixed;
  most_unproven_ = 0;
  served_ = 0;
  const TreeView points = trees_.points(), edges = trees_.edges(), faces = trees_.faces();
  reach_ = reach_now();
  scale_ = 1;
  const auto separation = static_cast<float>(separation_ * unit_ * (1 + 0x1p-20));
  const PackedVertex* vertices = trees_.motion().vertices.data();
  vf_.make(
      {PairKind::vertex_face, kernels_, {points, faces, vertices, 1 / unit_}, points_, faces_, reach_, separation, t});
  ee_.make({PairKind::edge_edge, kernels_, {edges, edges, vertices, 1 / unit_}, edges_, edges_, reach_, separation, t});
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
  return (last_.capacity() + where_.capacity()) * sizeof(Point) + vf_.memory_bytes() + ee_.memory_bytes() +
         points_.memory_bytes() + edges_.memory_bytes() + faces_.memory_bytes();
}

}  // namespace tamis
