#include "engines/tamis/near_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engines/cancellation.hpp"
#include "engines/stage_counts.hpp"
#include "engines/stopwatch.hpp"
#include "numerics/assert.hpp"

namespace tamis {
NearSearch::NearSearch(const Mesh& mesh, const Options& options, const Kernels& kernels, FeatureTrees& trees)
    : mesh_(mesh), options_(options), kernels_(kernels), trees_(trees), finders_([this] {
        return NearFinder(kernels_, trees_.motion(), options_);
      }) {}

void NearSearch::find(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                      Statistics& statistics) {
  step_ = {positions, positions};
  trees_.update(step_, separations, statistics);
  Stopwatch watch;
  for (NearFinder& finder : finders_) finder.begin(step_);
  trees_.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) { search(kind, a, b); });
  gather(statistics, watch.lap());
  describe(pairs);
  statistics.seconds.solve += watch.lap();
}

void NearSearch::search(PairKind kind, const TreeView& a, const TreeView& b) {
  TAMIS_ASSERT(trees_.are_of(step_));
  constexpr int kGrain = 8;
  tbb::parallel_for(tbb::blocked_range<int>(0, a.leaf_blocks, kGrain), [&](const tbb::blocked_range<int>& part) {
    bool is_known = false;
    NearFinder& finder = finders_.local(is_known);
    if (!is_known) finder.begin(step_);
    finder.search(kind, a, b, part.begin(), part.end());
  });
}

void NearSearch::gather(Statistics& statistics, double seconds) {
  StageCount boxes{"boxes"}, near{"near"};
  double traverse = 0, solving = 0;
  for (auto& list : lists_) list.clear();
  for (NearFinder& finder : finders_) {
    add(boxes, finder.boxes);
    add(near, finder.near);
    statistics.decided_by += finder.decided_by;
    statistics.nodes_visited += finder.nodes_visited;
    traverse += finder.traverse;
    solving += finder.solving;
    for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
      auto &list = lists_[kind], &found = finder.found[kind];
      if (list.empty())
        list.swap(found);
      else
        list.insert(list.end(), found.begin(), found.end());
    }
  }
  statistics.stages = {boxes, near};
  statistics.isa = kernels_.isa;
  const double sum = traverse + solving, share = sum > 0 ? seconds / sum : 0;
  statistics.seconds.traverse = share * traverse;
  statistics.seconds.solve = share * solving;
  for (auto& list : lists_) order_.sort(list, mesh_.vertex_count(), [&] { stop_if_cancelled(options_); });
}

void NearSearch::describe(std::vector<NearPair>& pairs) {
  std::size_t count = 0;
  for (const auto& list : lists_) count += list.size();
  pairs.resize(count);
  NearPair* out = pairs.data();
  for (std::size_t kind = 0; kind < kPairKinds; ++kind) {
    const auto& list = lists_[kind];
    constexpr std::size_t kGrain = 4096;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, list.size(), kGrain), [&](const auto& part) {
      NearFinder& finder = finders_.local();
      finder.describe(static_cast<PairKind>(kind), step_, list.data() + part.begin(), part.size(), out + part.begin());
    });
    out += list.size();
  }
}

std::uint64_t NearSearch::memory_bytes() const {
  std::uint64_t bytes = order_.memory_bytes();
  for (const auto& list : lists_) bytes += list.capacity() * sizeof(PairVertices);
  for (const NearFinder& finder : finders_) bytes += finder.memory_bytes();
  return bytes;
}

}  // namespace tamis
