// The default method: boxes that move in time, slab clip, DNF, NCF, certified roots; pairs stream through in small
// buffers. What may touch within the next steps is listed where a mesh goes on as it did, and nothing else.
#include "engines/engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engines/rest_engine.hpp"
#include "engines/stopwatch.hpp"
#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/gap_memory.hpp"
#include "engines/tamis/intersection_search.hpp"
#include "engines/tamis/near_search.hpp"
#include "engines/tamis/pairs_ahead.hpp"
#include "engines/tamis/pipelines.hpp"
#include "engines/tamis/samples.hpp"

namespace tamis {
namespace {

/// The smallest float at or after a time of the step.
float float_after(double t) {
  const auto f = static_cast<float>(t);
  return static_cast<double>(f) >= t ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

/// A step is short while edges move by less than this many times their length (docs/performance.md: "Short steps").
constexpr double kShort = 0.3;

class TamisEngine final : public Engine, public RestEngine {
 public:
  TamisEngine(const Mesh& mesh, const Options& options)
      : mesh_(mesh),
        options_(options),
        kernels_(kernels(options.isa)),
        trees_(mesh, kernels_, options.filter),
        ahead_(mesh, options),
        memory_(mesh, kernels_, trees_),
        pipelines_(kernels_, trees_.motion(), options),
        near_(mesh, options, kernels_, trees_),
        intersections_(mesh, options, kernels_, trees_) {}

  void find(FoundContacts& found, Statistics& statistics) override {
    const bool is_listed = prepare(found, statistics);
    const Stopwatch watch;
    pipelines_.begin(found);
    const bool wants_all = found.question() == Question::all_contacts;
    const std::span<const Sample> samples = wants_all ? std::span<const Sample>(kAllBlocks) : kSamples;
    if (is_listed)
      search_lists(found, samples);
    else
      search_trees(found, samples);
    ahead_.end(found);
    collect(statistics, watch.seconds());
  }

  void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                 Statistics& statistics) override {
    near_.find(positions, separations, pairs, statistics);
  }
  void find_intersections(const Positions& positions, Intersections wanted, std::vector<Intersection>& found,
                          Statistics& statistics) override {
    intersections_.find(positions, wanted, found, statistics);
  }
  RestEngine* at_rest() override { return this; }

  std::uint64_t memory_bytes() const override {
    return trees_.memory_bytes() + ahead_.memory_bytes() + memory_.memory_bytes() + pipelines_.memory_bytes() +
           near_.memory_bytes() + intersections_.memory_bytes();
  }

 private:
  /// Positions and what is to be searched are those of the question then: true, lists; false, the trees.
  bool prepare(const FoundContacts& found, Statistics& statistics) {
    nodes_ahead_ = 0;
    bool is_listed = ahead_.begin(found);
    if (!is_listed) {
      // Also where lists are made, of another step: whether the order has become poor shows in questions alone.
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
    measure_motion();
    t_limit_ = 1;
    pipelines_.begin(candidates);
    for (const Sample& sample : kSamples) {
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

  /// Of some thousand edges, in the mesh's order: what follows from it may not depend on the trees and their past.
  void measure_motion() {
    constexpr std::size_t kSample = 4096;
    moved_ = size_ = 0;
    const auto edges = mesh_.edges();
    const auto& boxes = trees_.motion().box_vertices;
    for (std::size_t e = 0; e < edges.size(); e += 1 + edges.size() / kSample) {
      const auto &a = boxes[static_cast<std::size_t>(edges[e][0])].at,
                 &b = boxes[static_cast<std::size_t>(edges[e][1])].at;
      for (int axis = 0; axis < 3; ++axis) {
        moved_ += static_cast<double>(std::fabs(a[3 + axis] - a[axis]));
        size_ += static_cast<double>(std::fabs(b[axis] - a[axis]));
      }
    }
  }

  /// Until `t_limit` boxes grow so little by being swept that when they meet need not be known.
  bool is_short(float t_limit) const { return static_cast<double>(t_limit) * moved_ <= kShort * size_; }

  /// The pairs that were listed ahead.
  void search_lists(FoundContacts& found, std::span<const Sample> samples) {
    t_limit_ = 1;
    constexpr std::size_t kPart = 1024, kGrain = 8;
    for (const Sample& sample : samples) {
      trees_.for_each_kind([&](PairKind kind, const TreeView&, const TreeView&) {
        const PairList& pairs = ahead_.list(kind);
        const int parts = static_cast<int>((pairs.size() + kPart - 1) / kPart);
        pipelines_.for_each_part(
            found, kind, count_in(sample, parts), kGrain, [&](StagePipeline& pipeline, int begin, int end) {
              for (int i = begin; i < end; ++i) {
                const auto first = static_cast<std::size_t>(sample.first + i * sample.stride) * kPart;
                pipeline.search(kind, pairs, first, std::min(first + kPart, pairs.size()), ahead_.when(), t_limit_);
              }
            });
      });
      learn(found);
    }
  }

  void search_trees(FoundContacts& found, std::span<const Sample> samples) {
    measure_motion();
    memory_.begin(found.step());
    search(found, samples);
    memory_.end(found.step(), t_limit_);
  }

  /// What is remembered first, where that serves; then everything, unless it has turned out that all else is apart.
  void search(FoundContacts& found, std::span<const Sample> samples) {
    t_limit_ = 1;
    const bool wants_all = found.question() == Question::all_contacts;
    const bool may_help = memory_.serves() && (!wants_all || memory_.covers(1));
    const bool is_all_else_apart = may_help && search_remembered(found, samples);
    for (const Sample& sample : samples) {
      trees_.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) {
        if (!(is_all_else_apart && can_cross(kind))) search_sample(found, kind, a, b, sample);
      });
      learn(found);
    }
  }

  /// False: some of what is not listed may touch.
  bool search_remembered(FoundContacts& found, std::span<const Sample> samples) {
    memory_.use_lists();
    for (const GapBand& band : kGapBands) {
      for (const Sample& sample : samples) {
        trees_.for_each_kind([&](PairKind kind, const TreeView& a, const TreeView& b) {
          if (can_cross(kind)) search_band(found, kind, a, b, band, sample);
        });
        learn(found);
      }
      if (!memory_.covers(t_limit_)) return false;
    }
    return true;
  }

  /// The step is shortened only between samples, and bands: the answer knows nothing of threads.
  void learn(FoundContacts& found) {
    pipelines_.gather(found);
    t_limit_ = std::min(t_limit_, float_after(found.latest()));
  }

  void search_sample(const FoundContacts& found, PairKind kind, const TreeView& a, const TreeView& b,
                     const Sample& sample) {
    constexpr std::size_t kGrain = 8;
    pipelines_.for_each_part(
        found, kind, count_in(sample, a.leaf_blocks), kGrain, [&](StagePipeline& pipeline, int begin, int end) {
          const int first = sample.first + begin * sample.stride, last = sample.first + end * sample.stride;
          const BlockRange blocks{first, std::min(last, a.leaf_blocks), sample.stride};
          pipeline.search(kind, a, b, blocks, t_limit_, is_short(t_limit_));
        });
  }

  void search_band(const FoundContacts& found, PairKind kind, const TreeView& a, const TreeView& b, const GapBand& band,
                   const Sample& sample) {
    constexpr std::size_t kGrain = 64;
    pipelines_.for_each_part(found, kind, count_in(sample, a.leaf_blocks), kGrain,
                             [&](StagePipeline& pipeline, int begin, int end) {
                               std::vector<std::int32_t>& others = pipeline.others();
                               for (int i = begin; i < end; ++i) {
                                 const int block = sample.first + i * sample.stride;
                                 others.clear();
                                 memory_.append_unproven(kind, block, band, t_limit_, others);
                                 if (!others.empty())
                                   pipeline.search(kind, a, b, block, others, t_limit_, is_short(t_limit_));
                               }
                             });
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
  GapMemory memory_;
  float t_limit_ = 1;              ///< nothing later in this question's step is of interest
  double moved_ = 0, size_ = 0;    ///< sums of some edges' displacements and lengths
  std::uint64_t nodes_ahead_ = 0;  ///< visited to list pairs, in this question
  Pipelines pipelines_;
  NearSearch near_;
  IntersectionSearch intersections_;
};

}  // namespace

std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options) {
  return std::make_unique<TamisEngine>(mesh, options);
}

}  // namespace tamis
