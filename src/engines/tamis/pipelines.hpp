// The stage pipelines of all threads that take part in a question.
#pragma once
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "engines/tamis/stage_pipeline.hpp"

namespace tamis {

class Pipelines {
 public:
  /// As StagePipeline.
  Pipelines(const Kernels& kernels, const PackedMotion& motion, const Options& options, const Mesh* edges_of = nullptr)
      : of_threads_(
            [&kernels, &motion, &options, edges_of] { return StagePipeline(kernels, motion, options, edges_of); }) {}

  void begin(const FoundContacts& question) {
    for (StagePipeline& pipeline : of_threads_) pipeline.begin(question);
  }

  /// f(pipeline of the thread, begin, end) for all parts of 0 to `count`.
  template <class F>
  void for_each_part(const FoundContacts& question, PairKind kind, int count, std::size_t grain, const F& f) {
    if (!question.wants(kind)) return;
    tbb::parallel_for(tbb::blocked_range<int>(0, count, grain), [&](const tbb::blocked_range<int>& part) {
      bool is_known = false;
      StagePipeline& pipeline = of_threads_.local(is_known);
      if (!is_known) pipeline.begin(question);
      f(pipeline, part.begin(), part.end());
    });
  }

  /// f(pipeline) for each, with nothing left in its buffers.
  template <class F>
  void finish(const F& f) {
    for (StagePipeline& pipeline : of_threads_) {
      pipeline.finish();
      f(pipeline);
    }
  }

  /// What each has found goes to `found`, and what all know to each.
  void gather(FoundContacts& found) {
    finish([&](StagePipeline& pipeline) { found.take(pipeline.found()); });
    for (StagePipeline& pipeline : of_threads_) pipeline.found().learn(found);
  }

  PipelineCounts counts() const {
    PipelineCounts sum;
    for (const StagePipeline& pipeline : of_threads_) sum += pipeline.counts();
    return sum;
  }
  std::uint64_t memory_bytes() const {
    std::uint64_t bytes = 0;
    for (const StagePipeline& pipeline : of_threads_) bytes += pipeline.memory_bytes();
    return bytes;
  }

 private:
  tbb::enumerable_thread_specific<StagePipeline> of_threads_;
};

}  // namespace tamis
