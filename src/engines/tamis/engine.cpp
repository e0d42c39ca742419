// The default method: boxes that move in time, slab clip, DNF, NCF, certified roots; pairs stream through in small
// buffers. What may touch within the next steps is listed where a mesh goes on as it did, and nothing else.
#include "engines/engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/stopwatch.hpp"
#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/intersection_search.hpp"
#include "engines/tamis/near_search.hpp"
#include "engines/tamis/pairs_ahead.hpp"
#include "engines/tamis/pipelines.hpp"
#include "engines/tamis/samples.hpp"
#include "engines/tamis/step_length.hpp"
#include "numerics/assert.hpp"

namespace tamis {
namespace {

/// The smallest float at or after a time of the step.
float float_after(double t) {
  const auto f = static_cast<float>(t);
  return static_cast<double>(f) >= t ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

class TamisEngine final : public Engine {
 public:
  TamisEngine(const Mesh& mesh, const Options& options)
      : mesh_(mesh),
        options_(options),
        kernels_(kernels(options.isa)),
        trees_(mesh, options, kernels_),
        ahead_(mesh),
        pipelines_(kernels_, trees_.motion(), options),
        near_(mesh, options, kernels_, trees_),
        intersections_(mesh, options, kernels_, trees_) {}

  void find(FoundContacts& found, Statistics& statistics) override {
    const bool is_listed = prepare(found, statistics);
    const Stopwatch watch;
    pipelines_.begin(found);
    if (is_listed) search_lists(found);
    const bool is_open = !is_listed || ahead_.leaves_open(found);
    if (is_listed && is_open) trees_.update(found.step(), found.separations(), statistics);
    if (is_open) search_trees(found);
    ahead_.end(found);
    collect(statistics, watch.seconds());
  }

  SafeStep find_step_length(const Step& step, const Separations& separations, double fraction,
                            Statistics& statistics) override {
    return step_lengths().find(step, separations, fraction, statistics);
  }
  void find_step_ends(const Step& step, const Separations& separations, double fraction, std::vector<StepLimit>& ends,
                      Statistics& statistics) override {
    step_lengths().find_all(step, separations, fraction, ends, statistics);
  }
  void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                 Statistics& statistics) override {
    near_.find(positions, separations, pairs, statistics);
  }
  void find_intersections(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                          Statistics& statistics) override {
    intersections_.find(positions, wanted, found, statistics);
  }

  std::uint64_t memory_bytes() const override {
    return trees_.memory_bytes() + ahead_.memory_bytes() + pipelines_.memory_bytes() + near_.memory_bytes() +
           intersections_.memory_bytes() + (step_lengths_ ? step_lengths_->memory_bytes() : 0);
  }

 private:
  /// Prepares for this question. Returns true if the listed pairs are to be asked first, false if the trees must be
  /// searched.
  bool prepare(const FoundContacts& found, Statistics& statistics) {
    nodes_ahead_ = 0;
    bool is_listed = ahead_.begin(found);
    if (!is_listed) {
      // Refit to the question even if lists follow: the decision to rebuild must not see the predicted step.
      trees_.update(found.step(), found.separations(), statistics);
      if (!ahead_.plan(found)) return false;
      const Stopwatch watch;
      is_listed = look_ahead(found.separations());
      if (!is_listed) trees_.look_at(found.step(), found.separations());
      statistics.seconds.build += watch.seconds();
    }
    if (is_listed) trees_.move_vertices(found.step(), found.separations(), statistics);
    return is_listed;
  }

  /// Lists what may touch within the next steps. False: that is too much.
  bool look_ahead(const Separations& separations) {
    FoundContacts candidates(options_);
    const int leaf_blocks = trees_.points().leaf_blocks + trees_.edges().leaf_blocks;
    candidates.begin_candidates(ahead_.way(), separations, ahead_.room(), PairsAhead::most_pairs(leaf_blocks));
    trees_.look_at(ahead_.way(), {separations.fixed + 2 * ahead_.room()});
    t_limit_ = ahead_.until();
    pipelines_.begin(candidates);
    for (const Sample& sample : Samples(trees_.most_leaf_blocks())) {
      trees_.for_each_kind(
          [&](PairKind kind, const TreeView& a, const TreeView& b) { search_sample(candidates, kind, a, b, sample); });
      pipelines_.finish([&](StagePipeline& pipeline) { ahead_.list_found(pipeline); });
    }
    nodes_ahead_ = pipelines_.counts().nodes_visited;
    const bool are_too_many = candidates.are_too_many();
    if (are_too_many)
      ahead_.give_up();
    else
      ahead_.complete();
    return !are_too_many;
  }

  /// The pairs that were listed ahead.
  void search_lists(FoundContacts& found) {
    t_limit_ = 1;
    constexpr std::size_t kPart = 1024, kGrain = 8;
    const auto parts_of = [&](PairKind kind) {
      return static_cast<int>((ahead_.list(kind).size() + kPart - 1) / kPart);
    };
    const int most_parts = std::max(parts_of(PairKind::vertex_face), parts_of(PairKind::edge_edge));
    for (const Sample& sample : samples_for(found, most_parts)) {
      trees_.for_each_kind([&](PairKind kind, const TreeView&, const TreeView&) {
        const PairList& pairs = ahead_.list(kind);
        pipelines_.for_each_part(
            found, kind, sample.count_in(parts_of(kind)), kGrain, [&](StagePipeline& pipeline, int begin, int end) {
              for (int i = begin; i < end; ++i) {
                const auto first = static_cast<std::size_t>(sample.first + i * sample.stride) * kPart;
                pipeline.search(kind, pairs, first, std::min(first + kPart, pairs.size()), ahead_.when(), t_limit_);
              }
            });
      });
      learn(found);
    }
  }

  void search_trees(FoundContacts& found) {
    t_limit_ = 1;
    for (const Sample& sample : samples_for(found, trees_.most_leaf_blocks())) {
      trees_.for_each_kind(
          [&](PairKind kind, const TreeView& a, const TreeView& b) { search_sample(found, kind, a, b, sample); });
      learn(found);
    }
  }

  /// All contacts have nothing to learn from an early one.
  static Samples samples_for(const FoundContacts& asked, int parts) {
    return asked.question() == Question::all_contacts ? Samples() : Samples(parts);
  }

  /// The step is shortened only between samples: the answer knows nothing of threads.
  void learn(FoundContacts& found) {
    pipelines_.gather(found);
    t_limit_ = std::min(t_limit_, float_after(found.latest()));
  }

  /// REQUIRES: trees of the question's step.
  void search_sample(const FoundContacts& found, PairKind kind, const TreeView& a, const TreeView& b,
                     const Sample& sample) {
    TAMIS_ASSERT(trees_.are_of(found.step()));
    constexpr std::size_t kGrain = 8;
    pipelines_.for_each_part(
        found, kind, sample.count_in(a.leaf_blocks), kGrain, [&](StagePipeline& pipeline, int begin, int end) {
          const int first = sample.first + begin * sample.stride, last = sample.first + end * sample.stride;
          const BlockRange blocks{first, std::min(last, a.leaf_blocks), sample.stride};
          pipeline.search(kind, a, b, blocks, t_limit_);
        });
  }

  StepLengthSearch& step_lengths() {
    if (!step_lengths_) step_lengths_ = std::make_unique<StepLengthSearch>(mesh_, options_, kernels_, trees_);
    return *step_lengths_;
  }

  void collect(Statistics& statistics, double seconds) {
    pipelines_.counts().report(statistics, seconds, !trees_.motion().separations.any());
    statistics.nodes_visited += nodes_ahead_;
    statistics.isa = kernels_.isa;
  }

  const Mesh& mesh_;
  const Options& options_;
  const Kernels& kernels_;
  FeatureTrees trees_;
  PairsAhead ahead_;
  float t_limit_ = 1;              ///< nothing later in this question's step is of interest
  std::uint64_t nodes_ahead_ = 0;  ///< visited to list pairs, in this question
  Pipelines pipelines_;
  NearSearch near_;
  IntersectionSearch intersections_;
  std::unique_ptr<StepLengthSearch> step_lengths_;  ///< made by the first question that needs it
};

}  // namespace

std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options) {
  return std::make_unique<TamisEngine>(mesh, options);
}

}  // namespace tamis
