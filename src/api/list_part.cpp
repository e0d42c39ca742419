#include "api/list_part.hpp"

#include <algorithm>
#include <memory>

#include "api/pair_faults.hpp"
#include "numbers/assert.hpp"
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

  PairBuffer pairs, rest;
  std::int32_t places[kPairsPerBatch + PairBuffer::kPadding];
  std::int32_t undecided[kPairsPerBatch];
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
    if (!batch) batch = std::make_unique_for_overwrite<Batch>();
    const int at = batch->pairs.count++;
    put(kind, pair.vertices, batch->pairs, at);
    for (const Index v : std::span(pair.vertices).template first<kCorners>()) {
      __builtin_prefetch(part_.step.start[v]);
      __builtin_prefetch(part_.step.end[v]);
    }
    batch->places[at] = place;
    return batch->pairs.count < Batch::kPairsPerBatch || decide_batch(kind);
  }

  bool decide_batch(PairKind kind) {
    Batch& batch = *batches_[static_cast<std::size_t>(kind)];
    TAMIS_ASSERT(batch.pairs.count <= Batch::kPairsPerBatch);
    const auto& [start, end] = part_.step;
    const StepRows vertices{start.data(), end.data(), start.stride(), end.stride()};
    const ListedPairs list{vertices, batch.places, part_.options.min_separation, part_.options.latest, within(kind)};
    const int undecided = part_.kernels.of(kind).decide_list(list, batch.pairs, batch.rest, results_, batch.undecided);
    TAMIS_ASSERT(0 <= undecided && undecided <= batch.pairs.count);
    batch.pairs.count = 0;
    return std::all_of(batch.undecided, batch.undecided + undecided,
                       [&](std::int32_t place) { return decide_singly(kind, place); });
  }

  WithinScratch* within(PairKind kind) {
    if (!is_about_distance(kind, part_.options.min_separation)) return nullptr;
    if (!within_) within_ = std::make_unique_for_overwrite<WithinScratch>();
    return within_.get();
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
  std::unique_ptr<WithinScratch> within_;
};

}  // namespace

bool decide_part_of_list(const ListPart& part, std::span<PairResult> results) {
  TAMIS_ASSERT(part.step.start.count() == part.step.end.count() && results.size() == part.pairs.size());
  return PartDecision(part, results.data()).run();
}

}  // namespace tamis
