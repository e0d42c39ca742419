// Finds the edges that pass through triangles, or touch them, in one pose. A vertex that runs along the edge during a
// step touches exactly the triangles that the edge meets. So this is decided as vertex-face contacts are.
#pragma once
#include <span>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/engine/thread_streams.hpp"
#include "search/query/bound.hpp"

namespace tamis {

/// Shared by the threads.
struct IntersectionQuery {
  const Query& query;
  Bound bound = {};  ///< settled: the answer is complete
};

class IntersectionConsumer final : public PairStream {
 public:
  using Shared = IntersectionQuery;

  using PairStream::PairStream;

  void begin(IntersectionQuery& shared);
  const std::vector<Intersection>& found() const { return found_; }

  bool wants(PairKind) const override { return !shared_->bound.is_settled(); }
  SearchKernel kernel(PairKind) const override { return thread().kernels.along_edges.search; }
  void consume(PairKind kind, PairBuffer& pairs) override;
  std::uint64_t memory_bytes() const { return held_bytes(found_); }

 private:
  void add(const PairBuffer& pairs, int place, const PairResult& result);
  /// `places`: of the pairs that lanes left undecided.
  void decide_left(const PairBuffer& pairs, std::span<const std::int32_t> places);

  IntersectionQuery* shared_ = nullptr;
  std::vector<Intersection> found_;
};

class IntersectionSearch {
 public:
  /// Keeps a reference.
  explicit IntersectionSearch(Workspace& workspace) : workspace_(workspace), streams_(workspace) {}

  /// As Engine::find_intersections.
  void find(const Query& query, std::vector<Intersection>& found, Statistics& statistics);
  std::uint64_t memory_bytes() const { return streams_.memory_bytes(); }

 private:
  Workspace& workspace_;
  ThreadStreams<IntersectionConsumer> streams_;
};

}  // namespace tamis
