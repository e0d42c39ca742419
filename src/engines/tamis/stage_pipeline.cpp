#include "engines/tamis/stage_pipeline.hpp"

#include <algorithm>
#include <iterator>

#include "engines/cancellation.hpp"
#include "engines/tamis/pair_buffers.hpp"
#include "narrow/decide.hpp"
#include "narrow/sharp_bracket.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// Has the edge between these vertices that number?
[[maybe_unused]] bool is_edge(const Mesh& mesh, Index number, Index start, Index end) {
  return 0 <= number && static_cast<std::size_t>(number) < mesh.edges().size() &&
         mesh.edges()[static_cast<std::size_t>(number)] == Edge{std::min(start, end), std::max(start, end)};
}

}  // namespace

PipelineCounts& PipelineCounts::operator+=(const PipelineCounts& other) {
  add(boxes, other.boxes);
  add(slab, other.slab);
  add(apart, other.apart);
  add(dnf, other.dnf);
  add(ncf, other.ncf);
  add(solve, other.solve);
  decided_by += other.decided_by;
  nodes_visited += other.nodes_visited;
  traverse += other.traverse;
  filter += other.filter;
  solving += other.solving;
  return *this;
}

void PipelineCounts::report(Statistics& statistics, double wall, bool has_filters) const {
  statistics.stages = {boxes, slab, dnf, ncf, solve};
  if (!has_filters) statistics.stages = {boxes, slab, apart, solve};
  statistics.decided_by = decided_by;
  statistics.nodes_visited = nodes_visited;
  const double sum = traverse + filter + solving, share = sum > 0 ? wall / sum : 0;
  statistics.seconds.traverse = share * traverse;
  statistics.seconds.filter = share * filter;
  statistics.seconds.solve = share * solving;
}

struct StagePipeline::Buffers {
  /// For what becomes of the filtered pairs.
  SolvedPair* room_for_solved() {
    TAMIS_ASSERT(static_cast<std::size_t>(filtered.count) <= std::size(solved));
    return solved;
  }

  PairBuffer boxes, slab, filtered;
  SolvedPair solved[PairBuffer::kCapacity];
  std::unique_ptr<WithinScratch> within;  ///< made where it is used
  PairKind kind = PairKind::vertex_face;
};

StagePipeline::StagePipeline(const Kernels& kernels, const PackedMotion& motion, const Options& options,
                             const Mesh* edges_of)
    : kernels_(kernels),
      motion_(motion),
      options_(options),
      edges_of_(edges_of),
      buffers_(std::make_unique<Buffers>()),
      found_(options) {}

StagePipeline::~StagePipeline() = default;
StagePipeline::StagePipeline(StagePipeline&&) noexcept = default;

void StagePipeline::begin(const FoundContacts& answer) {
  counts_ = {};
  for (PairList& pairs : candidates_) pairs = {};
  buffers_->boxes.count = 0;  // an exception may have left pairs of another question
  found_.begin_part_of(answer);
}

std::uint64_t StagePipeline::memory_bytes() const {
  std::uint64_t bytes = sizeof(Buffers) + found_.memory_bytes();
  for (const PairList& pairs : candidates_) bytes += pairs.memory_bytes();
  return bytes + (buffers_->within ? sizeof(WithinScratch) : 0);
}

void StagePipeline::search(PairKind kind, const TreeView& a, const TreeView& b, const BlockRange& blocks,
                           float t_limit) {
  Search search{a, b};
  search.t_limit = t_limit;
  watch_.lap();
  if (kind != buffers_->kind) decide_buffered(buffers_->kind);
  buffers_->kind = kind;
  search.pairs = &buffers_->boxes;
  search.flush = flush;
  search.context = this;
  const PairKernels& stages = stages_of(kind);
  for (int block = blocks.first; block < blocks.last && found_.wants(kind); block += blocks.stride)
    search_block(stages.search, search, block);
  counts_.nodes_visited += search.nodes_visited;
  counts_.traverse += watch_.lap();
}

void StagePipeline::search(PairKind kind, const PairList& pairs, std::size_t first, std::size_t last,
                           const TimeInterval<float>& when, float t_limit) {
  watch_.lap();
  if (kind != buffers_->kind) decide_buffered(buffers_->kind);
  buffers_->kind = kind;
  constexpr std::size_t kSome = 256;
  for (; first < last && found_.wants(kind); first += kSome) {
    if (static_cast<std::size_t>(buffers_->boxes.count) + kSome > PairBuffer::kCapacity) {
      counts_.traverse += watch_.lap();
      decide_buffered(kind);
    }
    pairs.copy(first, std::min(last, first + kSome), when, t_limit, buffers_->boxes);
  }
  counts_.traverse += watch_.lap();
}

void StagePipeline::finish() {
  watch_.lap();
  decide_buffered(buffers_->kind);
}

void StagePipeline::flush(Search& search) {
  auto& self = *static_cast<StagePipeline*>(search.context);
  self.counts_.traverse += self.watch_.lap();
  self.decide_buffered(self.buffers_->kind);
}

void StagePipeline::keep_buffered(PairKind kind) {
  auto& [boxes, slab, filtered, solved, within, current] = *buffers_;
  keep_each_once(kind, boxes);
  slab.count = filtered.count = 0;
  const PairKernels& stages = kernels_.of(kind);
  stages.slab(motion_.box_vertices.data(), motion_.box_separation(), boxes, slab);
  if (can_cross(kind) && !found_.separations().any())
    stages.filter_straying(motion_.vertices.data(), found_.stray(), slab, filtered);
  else
    cull_apart(kind);
  candidates(kind).append(filtered, vertex_count(kind));
  found_.count_candidates(filtered.count);
  boxes.count = 0;
}

void StagePipeline::decide_buffered(PairKind kind) {
  stop_if_cancelled(options_);
  if (found_.question() == Question::candidates) return keep_buffered(kind);
  auto& [boxes, slab, filtered, solved, within, current] = *buffers_;
  keep_each_once(kind, boxes);
  leave_out_unwanted(kind);
  const PairKernels& stages = stages_of(kind);
  const PackedVertex* vertices = motion_.vertices.data();
  of(counts_.boxes, kind) += static_cast<std::uint64_t>(boxes.count);
  of(counts_.slab, kind) += static_cast<std::uint64_t>(boxes.count);
  slab.count = filtered.count = 0;
  stages.slab(motion_.box_vertices.data(), motion_.box_separation(), boxes, slab);
  if (motion_.separations.any() || !can_cross(kind)) return decide_within_separation(kind);
  of(counts_.dnf, kind) += static_cast<std::uint64_t>(slab.count);
  of(counts_.ncf, kind) += static_cast<std::uint64_t>(stages.filter(vertices, slab, filtered));
  of(counts_.solve, kind) += static_cast<std::uint64_t>(filtered.count);
  boxes.count = 0;
  counts_.filter += watch_.lap();
  solve(kind);
  counts_.solving += watch_.lap();
}

void StagePipeline::cull_apart(PairKind kind) {
  kernels_.of(kind).cull_apart(motion_.box_vertices.data(), motion_.box_separation(), buffers_->slab,
                               buffers_->filtered);
}

void StagePipeline::decide_within_separation(PairKind kind) {
  auto& [boxes, slab, filtered, solved, within, current] = *buffers_;
  of(counts_.apart, kind) += static_cast<std::uint64_t>(slab.count);
  cull_apart(kind);
  of(counts_.solve, kind) += static_cast<std::uint64_t>(filtered.count);
  boxes.count = 0;
  counts_.filter += watch_.lap();
  if (!within) within = std::make_unique<WithinScratch>();
  const WithinRule rule{motion_.pair_separation(), found_.latest()};
  const auto come_within = kernels_.of(kind).come_within;
  add_solved(kind, filtered,
             come_within(motion_.vertices.data(), rule, filtered, *within, buffers_->room_for_solved()));
  counts_.solving += watch_.lap();
}

void StagePipeline::leave_out_unwanted(PairKind kind) {
  PairBuffer& pairs = buffers_->boxes;
  if (!found_.wants(kind)) pairs.count = 0;
  const PairFilter& filter = options_.filter;
  if (has_groups(filter))
    keep_wanted(pairs, [&, second = second_feature(kind)](int i) {
      return may_touch(filter, pairs.corner[0][i], pairs.corner[second][i]);
    });
  if (!filter.accepts && !found_.touches_at_start()) return;
  const auto is_wanted = [&](int i) {
    const PairVertices vertices = vertices_of(kind, pairs, i);
    return found_.wants(kind, vertices) && (!filter.accepts || filter.accepts(kind, vertices));
  };
  isolated([&] { keep_wanted(pairs, is_wanted); });
}

void StagePipeline::solve(PairKind kind) {
  const PairBuffer& pairs = buffers_->filtered;
  const int count = stages_of(kind).solve(motion_.vertices.data(), pairs, buffers_->slab, buffers_->room_for_solved());
  add_solved(kind, pairs, count);
}

void StagePipeline::add_solved(PairKind kind, const PairBuffer& pairs, int count) {
  int undecided = 0;
  TAMIS_ASSERT(0 <= count && count <= pairs.count);
  for (int i = 0; i < count; ++i) {
    const SolvedPair& s = buffers_->solved[i];
    if (!s.is_decided || !is_sharp(s.toi_lower, s.toi_upper)) {
      solve_singly(kind, pairs, s.pair);
      ++undecided;
      continue;
    }
    found_.add({kind,
                Certainty::certified,
                vertices_at(kind, pairs, s.pair),
                s.toi_lower,
                s.toi_upper,
                s.u,
                s.v,
                {s.normal[0], s.normal[1], s.normal[2]}});
  }
  counts_.decided_by.lanes += static_cast<std::uint64_t>(pairs.count - undecided);
}

void StagePipeline::solve_singly(PairKind kind, const PairBuffer& pairs, int pair) {
  stop_if_cancelled(options_);
  const PairVertices vertices = vertices_of(kind, pairs, pair);
  if (!found_.wants(kind, vertices)) return;
  const auto r = decide(kind, points_at(kind, pairs, pair), found_.rule_for(kind, vertices), counts_.decided_by);
  if (!r.touches) return;
  found_.add({kind, r.certainty, vertices_at(kind, pairs, pair), r.toi_lower, r.toi_upper, r.u, r.v, r.normal});
}

PairVertices StagePipeline::vertices_at(PairKind kind, const PairBuffer& pairs, int pair) const {
  PairVertices vertices = vertices_of(kind, pairs, pair);
  if (!edges_of_) return vertices;
  const Index start = vertices[0], end = pairs.corner[4][pair];
  vertices[0] = edges_of_->find_edge(start, end);
  TAMIS_ASSERT(is_edge(*edges_of_, vertices[0], start, end));
  return vertices;
}

PairPoints StagePipeline::points_at(PairKind kind, const PairBuffer& pairs, int pair) const {
  const PairVertices v = vertices_of(kind, pairs, pair);
  if (!edges_of_) return points_of(found_.step(), v);
  return points_along(found_.step().start, {v[0], pairs.corner[4][pair]}, {v[1], v[2], v[3]});
}

}  // namespace tamis
