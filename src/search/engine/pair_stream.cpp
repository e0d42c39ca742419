#include "search/engine/pair_stream.hpp"

#include <algorithm>

#include "numbers/assert.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/query/cancellation.hpp"

namespace tamis {

void PairStream::begin(const Query& query) {
  query_ = &query;
  thread_.counts = {};
  thread_.boxes.count = 0;
}

void PairStream::search(PairKind kind, const TreeView& a, const TreeView& b, const Sample& blocks, int count,
                        float t_limit) {
  begin_search(kind);
  Search search{a, b};
  search.t_limit = t_limit;
  search.has_outliers = thread().motion.frame.has_outliers;
  set_limits(search);
  search.pairs = &thread_.boxes;
  search.flush = flush;
  search.context = this;
  const SearchKernel find = kernel(kind);
  for (int i = 0; i < count && wants(kind); ++i) search_block(find, search, blocks.block(i));
  thread_.counts.nodes_visited += search.nodes_visited;
  thread_.counts.traverse += thread_.watch.lap();
}

void PairStream::search(PairKind kind, std::span<const Candidate> pairs, const TimeInterval<float>& when,
                        float t_limit) {
  begin_search(kind);
  constexpr std::size_t kPairsAtOnce = 256;
  while (!pairs.empty() && wants(kind)) {
    if (static_cast<std::size_t>(thread_.boxes.count) + kPairsAtOnce > PairBuffer::kCapacity) {
      thread_.counts.traverse += thread_.watch.lap();
      hand_over();
    }
    const std::size_t count = std::min(pairs.size(), kPairsAtOnce);
    append(pairs.first(count), when, t_limit, thread_.boxes);
    pairs = pairs.subspan(count);
  }
  thread_.counts.traverse += thread_.watch.lap();
}

void PairStream::finish() {
  thread_.watch.lap();
  hand_over();
}

void PairStream::flush(Search& search) {
  auto& self = *static_cast<PairStream*>(search.context);
  self.thread_.counts.traverse += self.thread_.watch.lap();
  self.hand_over();
  self.set_limits(search);
}

void PairStream::begin_search(PairKind kind) {
  TAMIS_ASSERT(kind == kind_ || thread_.boxes.count == 0);
  kind_ = kind;
  thread_.watch.lap();
}

void PairStream::hand_over() {
  stop_if_cancelled(query());
  if (thread_.boxes.count == 0) return;
  keep_each_once(kind_, thread_.boxes);
  consume(kind_, thread_.boxes);
  thread_.boxes.count = 0;
  thread_.counts.solving += thread_.watch.lap();
}

}  // namespace tamis
