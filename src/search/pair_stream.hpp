// One thread's stream of pairs: searches leaf blocks, or a list, into a small buffer, and consumes each full one. Each
// question has a class of its own, derived from this, that says how (*_consumer, *_search).
#pragma once
#include "coherence/pair_list.hpp"
#include "query/query.hpp"
#include "search/workspace.hpp"

namespace tamis {

/// Leaf blocks first, first + stride, ... below last.
struct BlockRange {
  int first, last, stride;
};

/// One is made for each thread, and begins anew with each query.
class PairStream {
 public:
  /// Keeps a reference.
  explicit PairStream(SearchThread& thread) : thread_(thread) {}
  virtual ~PairStream() = default;
  PairStream(const PairStream&) = delete;

  /// Every `blocks.stride`-th leaf block of `a` against all of `b`, as far as they may touch until `t_limit`.
  void search(PairKind kind, const TreeView& a, const TreeView& b, const BlockRange& blocks, float t_limit);
  /// The pairs first to last of a list, as far as they may touch at some time of `when`, by the list, and until
  /// `t_limit`, by this query.
  void search(PairKind kind, const PairList& pairs, std::size_t first, std::size_t last,
              const TimeInterval<float>& when, float t_limit);
  /// Consumes what is still in the buffer.
  void finish();
  /// So many pairs are in it.
  int waiting() const { return thread_.boxes.count; }

  /// Can pairs of this kind still change the answer? Asked before each search and each leaf block.
  virtual bool wants(PairKind) const { return true; }
  const Query& query() const { return *query_; }
  const SearchCounts& counts() const { return thread_.counts; }

 protected:
  /// Forgets what the thread had of another query: an exception may have left pairs.
  void begin(const Query& query);
  SearchThread& thread() const { return thread_; }

  /// What finds its pairs.
  virtual SearchKernel kernel(PairKind kind) const = 0;
  /// Says what the search is limited by besides time; asked again after each full buffer.
  virtual void set_limits(Search&) const {}
  /// Takes the pairs of thread().boxes, each of which is there once. What it leaves there is forgotten.
  virtual void consume(PairKind kind) = 0;

 private:
  static void flush(Search& search);
  void set_kind(PairKind kind);
  void hand_over();

  SearchThread& thread_;
  const Query* query_ = nullptr;
  PairKind kind_ = PairKind::vertex_face;  ///< of the pairs in the buffer
};

}  // namespace tamis
