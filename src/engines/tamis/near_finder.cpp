#include "engines/tamis/near_finder.hpp"

#include <algorithm>
#include <cmath>

#include "engines/cancellation.hpp"
#include "engines/tamis/pair_buffers.hpp"
#include "narrow/near_pair.hpp"

namespace tamis {

struct NearFinder::Buffers {
  PairBuffer boxes, near, unsure;
  PairKind kind = PairKind::vertex_face;
};

NearFinder::NearFinder(const Kernels& kernels, const PackedMotion& motion, const Options& options)
    : kernels_(kernels), motion_(motion), options_(options), buffers_(std::make_unique<Buffers>()) {}

NearFinder::~NearFinder() = default;
NearFinder::NearFinder(NearFinder&&) noexcept = default;

void NearFinder::begin(const Step& step) {
  step_ = step;
  for (auto& pairs : found) pairs.clear();
  boxes = {"boxes"};
  near = {"near"};
  decided_by = {};
  nodes_visited = 0;
  traverse = solving = 0;
  buffers_->boxes.count = 0;  // an exception may have left pairs of another question
}

std::uint64_t NearFinder::memory_bytes() const {
  std::uint64_t bytes = sizeof(Buffers);
  for (const auto& pairs : found) bytes += pairs.capacity() * sizeof(PairVertices);
  return bytes;
}

void NearFinder::search(PairKind kind, const TreeView& a, const TreeView& b, int first, int last) {
  watch_.lap();
  buffers_->kind = kind;
  Search search{a, b};
  search.widened = motion_.box_separation().fixed;
  search.pairs = &buffers_->boxes;
  search.flush = flush;
  search.context = this;
  for (int block = first; block < last; ++block) search_block(kernels_.of(kind).search_at_rest, search, block);
  nodes_visited += search.nodes_visited;
  traverse += watch_.lap();
  decide_buffered();
}

void NearFinder::flush(Search& search) {
  auto& self = *static_cast<NearFinder*>(search.context);
  self.traverse += self.watch_.lap();
  self.decide_buffered();
}

void NearFinder::decide_buffered() {
  stop_if_cancelled(options_);
  const PairKind kind = buffers_->kind;
  PairBuffer &pairs = buffers_->boxes, &is_near_enough = buffers_->near, &unsure = buffers_->unsure;
  keep_each_once(kind, pairs);
  of(boxes, kind) += static_cast<std::uint64_t>(pairs.count);
  is_near_enough.count = unsure.count = 0;
  kernels_.of(kind).find_near(motion_.vertices.data(), motion_.pair_separation(), pairs, is_near_enough, unsure);
  decided_by.lanes += static_cast<std::uint64_t>(pairs.count - unsure.count);
  pairs.count = 0;
  keep_wanted(unsure, [&](int i) {
    stop_if_cancelled(options_);
    const PairVertices v = vertices_of(kind, unsure, i);
    return is_near(kind, points_of(step_, v), motion_.separations.between(kind, v), decided_by);
  });
  keep(is_near_enough);
  keep(unsure);
  solving += watch_.lap();
}

void NearFinder::keep(PairBuffer& pairs) {
  const PairKind kind = buffers_->kind;
  if (!options_.filter.empty())
    keep_wanted(pairs, [&](int i) { return lets_pass(options_.filter, kind, vertices_of(kind, pairs, i)); });
  auto& list = found[static_cast<std::size_t>(kind)];
  const std::size_t before = list.size(), count = static_cast<std::size_t>(pairs.count);
  list.resize(before + count);
  for (std::size_t i = 0; i < count; ++i) list[before + i] = vertices_of(kind, pairs, static_cast<int>(i));
  of(near, kind) += count;
}

void NearFinder::describe(PairKind kind, const Step& step, const PairVertices* pairs, std::size_t count,
                          NearPair* out) {
  constexpr std::size_t kAtOnce = 128;  // what is on its way stays in the first cache
  PairBuffer& buffer = buffers_->near;
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    stop_if_cancelled(options_);
    buffer.count = static_cast<int>(std::min(kAtOnce, count - first));
    for (int i = 0; i < buffer.count; ++i)
      for (std::size_t c = 0; c < vertex_count(kind); ++c)
        buffer.corner[c][i] = pairs[first + static_cast<std::size_t>(i)][c];
    NearPair* const said = out + first;
    kernels_.of(kind).measure(motion_.vertices.data(), buffer, said);
    for (int i = 0; i < buffer.count; ++i)
      if (std::isnan(said[i].distance)) said[i] = near_pair(kind, said[i].vertices, points_of(step, said[i].vertices));
  }
}

}  // namespace tamis
