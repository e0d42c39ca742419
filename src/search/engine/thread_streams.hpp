// The streams of all threads that take part in a question.
#pragma once
#include "numbers/in_parts.hpp"
#include "numbers/pool.hpp"
#include "search/engine/pair_stream.hpp"
#include "search/engine/samples.hpp"

namespace tamis {

/// `Consumer`: a PairStream that is constructed with a SearchThread and begins with a `Consumer::Shared`. Pairs of one
/// part of a search wait in the buffer for the next part. The search for a kind ends when all are consumed.
template <class Consumer>
class ThreadStreams {
 public:
  using Shared = typename Consumer::Shared;

  /// Keeps a reference.
  explicit ThreadStreams(Workspace& workspace) : workspace_(workspace) {}

  /// Keeps a reference until the next begin().
  void begin(Shared& shared) {
    shared_ = &shared;
    for_each([&](Consumer& one) { one.begin(shared); });
  }

  /// Searches the sample's leaf blocks for pairs of all kinds that may touch until `t_limit`.
  void search_trees(const Sample& sample = {}, float t_limit = 1) {
    workspace_.trees.for_each_kind(
        [&](PairKind kind, const TreeView& a, const TreeView& b) { search(kind, a, b, sample, t_limit); });
  }
  /// Searches the sample's leaf blocks of `a` against all of `b`.
  void search(PairKind kind, const TreeView& a, const TreeView& b, const Sample& sample = {}, float t_limit = 1) {
    constexpr int kFewBlocks = 16, kBlocksPerPart = 8;  // waking other threads takes longer than a few blocks
    const int count = sample.count_in(a.leaf_blocks);
    for_each_part(kind, count, count <= kFewBlocks ? kFewBlocks : kBlocksPerPart,
                  [&](PairStream& stream, int begin, int end) {
                    stream.search(kind, a, b, {sample.block(begin), sample.stride}, end - begin, t_limit);
                  });
  }

  /// Takes the sample of the lists' parts, instead of leaf blocks. These are pairs that may touch at some time of
  /// `when`, for contacts until `t_limit`. `when` is in times of the lists' step, `t_limit` in times of the query's.
  void search_lists(const PairLists& lists, const Sample& sample = {}, const TimeInterval<float>& when = {0, 1},
                    float t_limit = 1) {
    for (std::size_t i = 0; i < kPairKinds; ++i) {
      const auto kind = static_cast<PairKind>(i);
      const PairList& list = lists[kind];
      const int count = sample.count_in(static_cast<int>(list.parts()));
      for_each_part(kind, count, 1, [&](PairStream& stream, int begin, int end) {
        for (int part = begin; part < end; ++part)
          stream.search(kind, list.part(static_cast<std::size_t>(sample.block(part))), when, t_limit);
      });
    }
  }

  template <class F>
  void for_each(const F& f) const {
    for (const std::unique_ptr<Consumer>& one : consumers_.all()) f(*one);
  }
  /// A consumer that nobody else has meanwhile.
  auto take() { return consumers_.take(); }

  /// Sums over all threads of this question.
  SearchCounts counts() const {
    SearchCounts sum;
    for_each([&](const Consumer& one) { sum += one.counts(); });
    return sum;
  }
  /// Adds the counts to the statistics, and returns them. `wall`: wall-clock seconds of the search. `stages`: the
  /// question's stages, in order.
  SearchCounts report(Statistics& statistics, double wall,
                      std::initializer_list<StageCount SearchCounts::*> stages) const {
    const SearchCounts sum = counts();
    statistics.isa = workspace_.kernels.isa;
    sum.add_to(statistics, wall, stages);
    workspace_.trees.add_search(sum.nodes_visited);
    return sum;
  }
  /// Bytes held beside the workspace.
  std::uint64_t memory_bytes() const {
    std::uint64_t bytes = 0;
    for_each([&](const Consumer& one) { bytes += one.memory_bytes(); });
    return bytes;
  }

 private:
  /// Calls f(the thread's stream, begin, end) for parts of 0 to `count`, unless no pair of the kind is wanted any more.
  template <class F>
  void for_each_part(PairKind kind, int count, int grain, const F& f) {
    if (!take()->wants(kind)) return;
    in_parts(count, grain, [&](int begin, int end) { f(*take(), begin, end); });
    finish();
  }

  /// Consumes the rest of the buffers, in parallel if that is much.
  void finish() {
    constexpr int kPairsWorthSharing = 512;
    int left = 0;
    for_each([&](const Consumer& one) { left += one.waiting(); });
    const auto all = consumers_.all();
    for_each_in_parts(all, left < kPairsWorthSharing ? all.size() : 1,
                      [](const std::unique_ptr<Consumer>& one) { one->finish(); });
  }

  Workspace& workspace_;
  Shared* shared_ = nullptr;
  Pool<Consumer> consumers_{[this](std::size_t i) {
    auto made = std::make_unique<Consumer>(workspace_.thread(i));
    made->begin(*shared_);
    return made;
  }};
};

}  // namespace tamis
