#include "api/list_part.hpp"

#include <algorithm>
#include <memory>

#include "api/pair_faults.hpp"
#include "numbers/assert.hpp"
#include "numbers/platform.hpp"
#include "numbers/raw_array.hpp"
#include "pair/narrow/decide.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/pair_vertices.hpp"

namespace tamis {
namespace {

template <std::size_t count>
bool are_rows(const FeaturePair& pair, Index rows) {
  bool result = true;
  for (std::size_t i = 0; i < count; ++i)
    result &= static_cast<std::uint32_t>(pair.vertices[i]) < static_cast<std::uint32_t>(rows);
  return result;
}

/// A batch of pairs of one kind.
struct Batch {
  static constexpr int kPairsPerBatch = 128;  // their vertices, prefetched as pairs come in, stay in the L1 cache

  PairBuffer pairs;
  std::int32_t places[kPairsPerBatch];  ///< of the pairs in the list
  DecisionRoom<kPairsPerBatch> room;
};

class PartDecision {
 public:
  PartDecision(const ListPart& part, PairResult* results) : part_(part), results_(results) {}

  bool run() {
    for (std::size_t i = 0; i < part_.pairs.size(); ++i) {
      const PairKind kind = part_.pairs[i].kind;
      if (!is_kind(kind)) return false;
      if (!with_kind(kind, [&](auto k) { return add<k()>(static_cast<std::int32_t>(i)); })) return false;
    }
    for (std::size_t kind = 0; kind < kPairKinds; ++kind)
      if (batches_[kind] && !decide_batch(static_cast<PairKind>(kind))) return false;
    return true;
  }

 private:
  template <PairKind kind>
  bool add(std::int32_t place) {
    constexpr std::size_t kCorners = vertex_count(kind);
    const FeaturePair& pair = part_.pairs[static_cast<std::size_t>(place)];
    if (!are_rows<kCorners>(pair, part_.step.start.count())) return false;
    auto& batch = batches_[static_cast<std::size_t>(kind)];
    if (!batch) batch = make_raw<Batch>();
    const int at = batch->pairs.count++;
    put(kind, pair.vertices, batch->pairs, at);
    for (const Index v : std::span(pair.vertices).template first<kCorners>()) {
      prefetch(part_.step.start[v]);
      prefetch(part_.step.end[v]);
    }
    batch->places[at] = place;
    return batch->pairs.count < Batch::kPairsPerBatch || decide_batch(kind);
  }

  bool decide_batch(PairKind kind) {
    Batch& batch = *batches_[static_cast<std::size_t>(kind)];
    TAMIS_ASSERT(batch.pairs.count <= Batch::kPairsPerBatch);
    const auto& [start, end] = part_.step;
    const StepRows vertices{start.data(), end.data(), start.stride(), end.stride()};
    LaneDecisions decisions = batch.room.lists();
    part_.kernels.of(kind).decide_rows(vertices, part_.options.min_separation, part_.options.latest, batch.pairs,
                                       *scratch_, decisions);
    for (int i = 0; i < batch.pairs.count; ++i) results_[batch.places[i]] = {};
    for (int i = 0; i < decisions.touching_count; ++i)
      results_[batch.places[decisions.touching[i].pair]] = decisions.touching[i].result;
    batch.pairs.count = 0;
    return std::all_of(decisions.undecided, decisions.undecided + decisions.undecided_count,
                       [&](std::int32_t pair) { return decide_singly(kind, batch.places[pair]); });
  }

  bool decide_singly(PairKind kind, std::int32_t place) {
    stop_if_cancelled(part_.options);
    const FeaturePair& pair = part_.pairs[static_cast<std::size_t>(place)];
    if (!fault_of(pair, part_.step).empty()) return false;
    PrecisionCount decided_by;
    const PairPoints points = points_of(part_.step, vertices_in_use(kind, pair.vertices));
    results_[place] = decide({kind, points, part_.options.min_separation}, decided_by, {part_.options.latest});
    return true;
  }

  const ListPart part_;
  PairResult* results_;
  std::unique_ptr<Batch> batches_[kPairKinds];
  const std::unique_ptr<DecisionScratch> scratch_ = make_raw<DecisionScratch>();
};

}  // namespace

bool decide_part_of_list(const ListPart& part, std::span<PairResult> results) {
  TAMIS_ASSERT(part.step.start.count() == part.step.end.count() && results.size() == part.pairs.size());
  return PartDecision(part, results.data()).run();
}

}  // namespace tamis
