// The default method: boxes that move in time, slab clip, DNF, NCF, certified roots; pairs stream through in small
// buffers, so no list of the step's candidates is ever stored.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <chrono>

#include "bvh/block_tree.hpp"
#include "detect/engine.hpp"
#include "detect/stage_pipeline.hpp"

namespace tamis {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

class TamisEngine final : public Engine {
 public:
  TamisEngine(const Mesh& mesh, const Options& options)
      : mesh_(mesh), options_(options), kernels_(kernels(options.isa)) {
    points_.set_features(1, mesh.points());
    edges_.set_features(2, std::span(mesh.edges().data()->data(), 2 * mesh.edges().size()));
    faces_.set_features(3, std::span(mesh.faces().data()->data(), 3 * mesh.faces().size()));
  }

  void find(const Step& step, Question question, std::vector<Contact>& contacts, Statistics& statistics) override {
    auto start = Clock::now();
    motion_.assign(step, mesh_.points(), options_.min_separation);
    statistics.seconds.bounds = seconds_since(start);
    start = Clock::now();
    update_trees(statistics);
    statistics.seconds.build = seconds_since(start);
    start = Clock::now();
    tbb::enumerable_thread_specific<StagePipeline> pipelines(
        [&] { return StagePipeline(kernels_, motion_, step, options_); });
    search_all(question, PairKind::vertex_face, points_.view(), faces_.view(), pipelines);
    search_all(question, PairKind::edge_edge, edges_.view(), edges_.view(), pipelines);
    PipelineCounts counts;
    for (StagePipeline& pipeline : pipelines) {
      pipeline.finish();
      counts += pipeline.counts();
      contacts.insert(contacts.end(), pipeline.contacts().begin(), pipeline.contacts().end());
    }
    counts.report(statistics, seconds_since(start));
    statistics.isa = kernels_.isa;
  }

  std::uint64_t memory_bytes() const override {
    return motion_.memory_bytes() + points_.memory_bytes() + edges_.memory_bytes() + faces_.memory_bytes();
  }

 private:
  void update_trees(Statistics& statistics) {
    statistics.rebuilt = !is_built_;
    for (BlockTree* tree : {&points_, &edges_, &faces_}) is_built_ ? tree->refit(motion_) : tree->build(motion_);
    is_built_ = true;
  }

  void search_all(Question, PairKind kind, const TreeView& a, const TreeView& b,
                  tbb::enumerable_thread_specific<StagePipeline>& pipelines) {
    tbb::parallel_for(tbb::blocked_range<int>(0, a.leaf_blocks, 16), [&](const tbb::blocked_range<int>& blocks) {
      pipelines.local().search(kind, a, b, blocks.begin(), blocks.end());
    });
  }

  const Mesh& mesh_;
  const Options& options_;
  const Kernels& kernels_;
  PackedMotion motion_;
  BlockTree points_, edges_, faces_;
  bool is_built_ = false;
};

}  // namespace

std::unique_ptr<Engine> make_tamis_engine(const Mesh& mesh, const Options& options) {
  return std::make_unique<TamisEngine>(mesh, options);
}

}  // namespace tamis
