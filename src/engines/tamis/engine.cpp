// The default method: boxes that move in time, slab clip, DNF, NCF, certified roots; pairs stream through in small
// buffers, so no list of the step's candidates is ever stored.
#include "engines/engine.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "bvh/block_tree.hpp"
#include "engines/tamis/samples.hpp"
#include "engines/tamis/stage_pipeline.hpp"

namespace tamis {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The smallest float at or after a time of the step.
float float_after(double t) {
  const auto f = static_cast<float>(t);
  return static_cast<double>(f) >= t ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

/// Refitting goes on until the leaf blocks' swept area exceeds by this factor what it was when they were built
/// (docs/performance.md: "When to rebuild").
constexpr double kPoor = 1.5;

/// A step is short while edges move by less than this many times their length (docs/performance.md: "Short steps").
constexpr double kShort = 0.3;

class TamisEngine final : public Engine {
 public:
  TamisEngine(const Mesh& mesh, const Options& options)
      : mesh_(mesh),
        kernels_(kernels(options.isa)),
        pipelines_([this, &options] { return StagePipeline(kernels_, motion_, options); }) {
    points_.set_features(mesh.points());
    edges_.set_features(mesh.edges());
    faces_.set_features(mesh.faces());
  }

  void find(FoundContacts& found, Statistics& statistics) override {
    auto start = Clock::now();
    motion_.assign(found.step(), mesh_.points(), found.separations());
    measure_motion();
    statistics.seconds.bounds = seconds_since(start);
    start = Clock::now();
    update_trees(statistics);
    statistics.seconds.build = seconds_since(start);
    start = Clock::now();
    for (StagePipeline& pipeline : pipelines_) pipeline.begin(found);
    if (found.question() == Question::all_contacts)
      search(found, kAllBlocks);
    else
      search(found, kSamples);
    collect(statistics, seconds_since(start));
  }

  std::uint64_t memory_bytes() const override {
    std::uint64_t bytes =
        motion_.memory_bytes() + points_.memory_bytes() + edges_.memory_bytes() + faces_.memory_bytes();
    for (const StagePipeline& pipeline : pipelines_) bytes += pipeline.memory_bytes();
    return bytes;
  }

 private:
  void update_trees(Statistics& statistics) {
    BlockTree* const trees[] = {&points_, &edges_, &faces_};
    const auto area = [&] { return points_.swept_area() + edges_.swept_area() + faces_.swept_area(); };
    if (built_area_ > 0) {
      for (BlockTree* tree : trees) tree->refit(motion_, kernels_.trees);
      if (area() <= kPoor * built_area_) return;
    }
    for (BlockTree* tree : trees) tree->build(motion_, kernels_.trees);
    // Areas are of the box frame, which holds the scene whatever its size; a scene without area is rebuilt each time.
    built_area_ = area();
    statistics.rebuilt = true;
  }

  /// Of some thousand edges, in the mesh's order: what follows from it may not depend on the trees and their past.
  void measure_motion() {
    constexpr std::size_t kSample = 4096;
    moved_ = size_ = 0;
    const auto edges = mesh_.edges();
    for (std::size_t e = 0; e < edges.size(); e += 1 + edges.size() / kSample) {
      const auto &a = motion_.box_vertices[static_cast<std::size_t>(edges[e][0])].at,
                 &b = motion_.box_vertices[static_cast<std::size_t>(edges[e][1])].at;
      for (int axis = 0; axis < 3; ++axis) {
        moved_ += static_cast<double>(std::fabs(a[3 + axis] - a[axis]));
        size_ += static_cast<double>(std::fabs(b[axis] - a[axis]));
      }
    }
  }

  /// Until `t_limit` boxes grow so little by being swept that when they meet need not be known.
  bool is_short(float t_limit) const { return static_cast<double>(t_limit) * moved_ <= kShort * size_; }

  /// The step is shortened only between samples: the answer knows nothing of threads.
  template <class Samples>
  void search(FoundContacts& found, const Samples& samples) {
    float t_limit = 1;
    for (const Sample& sample : samples) {
      search_sample(found, PairKind::vertex_face, points_.view(), faces_.view(), sample, t_limit);
      search_sample(found, PairKind::edge_edge, edges_.view(), edges_.view(), sample, t_limit);
      for (StagePipeline& pipeline : pipelines_) {
        pipeline.finish();
        found.take(pipeline.found());
      }
      for (StagePipeline& pipeline : pipelines_) pipeline.found().learn(found);
      t_limit = std::min(t_limit, float_after(found.latest()));
    }
  }

  void search_sample(const FoundContacts& found, PairKind kind, const TreeView& a, const TreeView& b,
                     const Sample& sample, float t_limit) {
    constexpr int kGrain = 8;
    if (!found.wants(kind)) return;
    const tbb::blocked_range<int> all(0, count_in(sample, a.leaf_blocks), kGrain);
    tbb::parallel_for(all, [&](const tbb::blocked_range<int>& part) {
      bool is_known = false;
      StagePipeline& pipeline = pipelines_.local(is_known);
      if (!is_known) pipeline.begin(found);
      const int first = sample.first + part.begin() * sample.stride, last = sample.first + part.end() * sample.stride;
      pipeline.search(kind, a, b, {first, std::min(last, a.leaf_blocks), sample.stride}, t_limit, is_short(t_limit));
    });
  }

  void collect(Statistics& statistics, double seconds) {
    PipelineCounts counts;
    for (const StagePipeline& pipeline : pipelines_) counts += pipeline.counts();
    counts.report(statistics, seconds, !motion_.separations.any());
    statistics.isa = kernels_.isa;
  }

  const Mesh& mesh_;
  const Kernels& kernels_;
  PackedMotion motion_;
  BlockTree points_, edges_, faces_;
  double built_area_ = 0;
  double moved_ = 0, size_ = 0;  ///< sums of some edges' displacements and lengths
  tbb::enumerable_thread_specific<StagePipeline> pipelines_;
};

}  // namespace

std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options) {
  return std::make_unique<TamisEngine>(mesh, options);
}

}  // namespace tamis
