// One thread's stream of pairs. It searches leaf blocks, or a list, into a small buffer, and consumes each full buffer.
// A derived class for each question says how (*_consumer, *_search).
#pragma once
#include "search/coherence/pair_lists.hpp"
#include "search/engine/samples.hpp"
#include "search/engine/workspace.hpp"
#include "search/query/query.hpp"

namespace tamis {

/// One is made for each thread, and begins anew with each query.
class PairStream {
 public:
  /// Keeps a reference.
  explicit PairStream(SearchThread& thread) : thread_(thread) {}
  virtual ~PairStream() = default;
  PairStream(const PairStream&) = delete;

  /// Searches the first `count` leaf blocks of a sample of `a` against all of `b`, for pairs that may touch until
  /// `t_limit`. REQUIRES, like the next function: no pairs of another kind in the buffer.
  void search(PairKind kind, const TreeView& a, const TreeView& b, const Sample& blocks, int count, float t_limit);
  /// Takes the pairs of a list that may touch at some time of `when`, for contacts until `t_limit`. `when` is in times
  /// of the list's step, `t_limit` in times of the query's.
  void search(PairKind kind, std::span<const Candidate> pairs, const TimeInterval<float>& when, float t_limit);
  /// Consumes the rest of the buffer.
  void finish();
  /// The number of pairs still in the buffer.
  int waiting() const { return thread_.boxes.count; }

  /// True if pairs of this kind can still change the answer. Called before each search and each leaf block.
  virtual bool wants(PairKind) const { return true; }
  const Query& query() const { return *query_; }
  const SearchCounts& counts() const { return thread_.counts; }

 protected:
  /// Begins a query, and drops pairs that an exception may have left of another one.
  void begin(const Query& query);
  SearchThread& thread() const { return thread_; }

  /// The kernel that searches for pairs of this kind.
  virtual SearchKernel kernel(PairKind kind) const = 0;
  /// Sets the search's limits other than time; called again after each full buffer.
  virtual void set_limits(Search&) const {}
  /// Consumes the pairs, each once, and may overwrite them.
  virtual void consume(PairKind kind, PairBuffer& pairs) = 0;

 private:
  static void flush(Search& search);
  void begin_search(PairKind kind);
  void hand_over();

  SearchThread& thread_;
  const Query* query_ = nullptr;
  PairKind kind_ = PairKind::vertex_face;  ///< of the pairs in the buffer
};

}  // namespace tamis
