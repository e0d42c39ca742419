// Decides the pairs of a list in lanes; compiled once for each instruction set. decide() runs the same tests on a pair,
// in the same order, so that it gives the same bits.
#include "pair/narrow/clipped_crossing.hpp"
#include "search/kernels/advance_lanes.hpp"
#include "search/kernels/crossings.hpp"
#include "search/kernels/isa_declarations.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {
namespace {

using Axes = SlabClip::Axes;

/// The pairs first, first + 1, ... of a buffer, and their slab clip; `places`: where their results go.
template <PairKind kind, Axes axes>
struct ClippedBatch : CrossingBatch {
  ClippedBatch(const ListedPairs& list, const PairBuffer& pairs, const std::int32_t* all_places, int at)
      : CrossingBatch{at,
                      lanes_in_use(pairs, at),
                      load_motion<kind>(list.vertices, pairs, at, {list.min_separation, false}),
                      {}},
        places(all_places + at),
        clip(SlabClip::clip<kind, axes>(motion, TimeInterval<DoubleLanes>{DoubleLanes(0), DoubleLanes(1)})) {
    part = widened(clip);
    finite = finite_lanes(motion);
    free = lanes & finite & bits((clip.t_in > clip.t_out) | (clip.t_in > DoubleLanes(list.latest)));
    lanes &= ~free;
  }
  /// Lanes that a crossing may decide.
  unsigned may_be_decided() const { return finite & ~bits((clip.t_in == DoubleLanes(0)) & may_start_coplanar(motion)); }

  const std::int32_t* places;
  TimeInterval<DoubleLanes> clip;
  unsigned finite, free;  ///< bits of lanes
};

template <PairKind kind>
class ListDecision {
 public:
  ListDecision(const ListedPairs& list, PairBuffer& rest, PairResult* results, std::int32_t* undecided)
      : list_(list), rest_(rest), results_(results), undecided_(undecided) {
    rest.count = 0;
  }

  /// Returns how many pairs are left undecided.
  int run(const PairBuffer& in) {
    if constexpr (can_cross(kind))
      if (list_.min_separation == 0) return find_crossings(in);
    AdvanceLanes<kind, StepRows, ListDecision>(list_.vertices, {list_.min_separation, false}, list_.latest,
                                               *list_.within, *this)
        .run(in);
    return undecided_count_;
  }

  // The sink of AdvanceLanes.
  void free(int i) { results_[list_.places[i]] = {}; }
  void undecided(int i) { undecided_[undecided_count_++] = list_.places[i]; }
  void touches(int i, const ContactLanes& contacts, int lane) {
    if (!contacts.has_place(lane)) return undecided(i);
    results_[list_.places[i]] = contacts.result(lane);
  }

 private:
  int find_crossings(const PairBuffer& in) {
    using Batch = ClippedBatch<kind, Axes::coordinates>;
    const auto make = [&](int first) {
      Batch batch(list_, in, list_.places, first);
      keep_free(batch.free, batch.places);
      const unsigned fit = batch.lanes & batch.may_be_decided();
      try_again(batch.lanes & ~fit, in, batch);
      batch.lanes = fit;
      return batch;
    };
    for_each_crossing<kind>(in.count, make, [&](const Batch& batch, const Crossing<DoubleLanes>& crossing) {
      try_again(leaves_undecided(batch, crossing), in, batch);
    });
    for (int first = 0; first < rest_.count; first += kDoubleLanes) look_in_halves(first);
    return undecided_count_;
  }

  template <class Batch>
  void try_again(unsigned lanes, const PairBuffer& in, const Batch& batch) {
    for_each_bit(lanes, [&](int i) {
      rest_places_[rest_.count] = batch.places[i];
      copy_corners(in, batch.first + i, rest_, rest_.count++);
    });
  }

  void look_in_halves(int first) {
    ClippedBatch<kind, Axes::all> batch(list_, rest_, rest_places_, first);
    keep_free(batch.free, batch.places);
    const unsigned fit = batch.lanes & batch.may_be_decided();
    leave_undecided(batch.lanes & ~fit, batch.places);
    batch.lanes = fit;
    if (!fit) return;
    const auto crossing = find_crossing_in_halves<kind>(batch.motion, batch.part);
    leave_undecided(leaves_undecided(batch, crossing), batch.places);
  }

  void keep_free(unsigned lanes, const std::int32_t* places) {
    for_each_bit(lanes, [&](int i) { results_[places[i]] = {}; });
  }
  void leave_undecided(unsigned lanes, const std::int32_t* places) {
    for_each_bit(lanes, [&](int i) { undecided_[undecided_count_++] = places[i]; });
  }

  /// Writes the results of the pairs that the crossing decides; returns the lanes of the others.
  template <Axes axes>
  unsigned leaves_undecided(const ClippedBatch<kind, axes>& batch, const Crossing<DoubleLanes>& crossing) {
    const auto s = clipped_crossing(crossing, batch.clip);
    const unsigned lanes = batch.lanes;
    const unsigned free = lanes & bits(s.is_free), touches = lanes & ~free & bits(s.touches);
    const unsigned late = touches & bits(s.lower > DoubleLanes(list_.latest));
    keep_free(free | late, batch.places);
    const ContactLanes contacts(s.lower, s.upper, s.u, s.v, s.normal);
    for_each_bit(touches & ~late, [&](int i) { results_[batch.places[i]] = contacts.result(i); });
    return lanes & ~free & ~touches;
  }

  const ListedPairs& list_;
  PairBuffer& rest_;
  PairResult* results_;
  std::int32_t* undecided_;
  std::int32_t rest_places_[PairBuffer::kSize];
  int undecided_count_ = 0;
};

}  // namespace

template <PairKind kind>
int decide_list(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
                std::int32_t* undecided) {
  return ListDecision<kind>(list, rest, results, undecided).run(in);
}

#define TAMIS_DECIDE_LIST(kind)                                                                             \
  template int decide_list<PairKind::kind>(const ListedPairs&, const PairBuffer&, PairBuffer&, PairResult*, \
                                           std::int32_t*)
TAMIS_DECIDE_LIST(vertex_face);
TAMIS_DECIDE_LIST(edge_edge);
TAMIS_DECIDE_LIST(vertex_edge);
TAMIS_DECIDE_LIST(vertex_vertex);

}  // namespace tamis::TAMIS_ISA
