// Decides pairs by their crossings (pair/narrow/clipped_crossing.hpp), as decided_by_crossings() does for one pair. Two
// batches of lanes at a time: while the roots of one are waited for, the other is worked on.
#pragma once
#include <optional>

#include "pair/narrow/clipped_crossing.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/contact_lanes.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind, Course course, class Vertices>
class CrossingLanes {
 public:
  /// Pairs whose contact begins after `latest` count as free. `rest` is scratch.
  CrossingLanes(Vertices vertices, double latest, AdvanceBuffer& rest, LaneDecisions& out)
      : vertices_(vertices), latest_(latest), rest_(rest), out_(out) {}

  void run(const PairBuffer& in) {
    rest_.pairs.count = 0;
    find_one_crossing(in);
    for (int first = 0; first < rest_.pairs.count; first += kDoubleLanes) find_crossing_in_halves(first);
  }

 private:
  using Lanes = DoubleLanes;
  using Axes = SlabClip::Axes;

  /// The pairs first, first + 1, ... of a buffer, in the times that the slab clip leaves.
  struct Batch {
    int first;
    unsigned fit;   ///< bits of the lanes that a crossing may decide
    unsigned left;  ///< bits of the other lanes that are not free
    PairMotion<Lanes> motion;
    TimeInterval<Lanes> clip, part;
  };

  template <Axes axes>
  Batch make_batch(const PairBuffer& pairs, int first) const {
    const auto m = load_motion<kind, course>(vertices_, pairs, first);
    const auto clip = SlabClip::clip<kind, axes>(m, TimeInterval<Lanes>{Lanes(0), Lanes(1)});
    const unsigned finite = finite_lanes(m),
                   free = finite & bits((clip.t_in > clip.t_out) | (clip.t_in > Lanes(latest_)));
    const unsigned fit = finite & ~bits((clip.t_in == Lanes(0)) & may_start_coplanar(m));
    const unsigned lanes = lanes_in_use(pairs, first) & ~free;
    return {first, lanes & fit, lanes & ~fit, m, clip, widened(clip)};
  }

  void find_one_crossing(const PairBuffer& in) {
    std::optional<Batch> waiting;
    for (int first = 0; first < in.count; first += kDoubleLanes) {
      const Batch batch = make_batch<Axes::coordinates>(in, first);
      try_again(in, first, batch.left);
      if (!batch.fit) continue;
      if (!waiting) {
        waiting.emplace(batch);
        continue;
      }
      const auto two = find_two_crossings<kind>(waiting->motion, waiting->part, batch.motion, batch.part);
      take_one_crossing(in, *waiting, two[0]);
      take_one_crossing(in, batch, two[1]);
      waiting.reset();
    }
    if (waiting) take_one_crossing(in, *waiting, find_crossing<kind>(waiting->motion, waiting->part));
  }

  void take_one_crossing(const PairBuffer& in, const Batch& batch, const Crossing<Lanes>& crossing) {
    std::int32_t places[kDoubleLanes];
    for (int i = 0; i < kDoubleLanes; ++i) places[i] = batch.first + i;
    try_again(in, batch.first, take(batch, crossing, places));
  }

  void try_again(const PairBuffer& in, int first, unsigned lanes) {
    for_each_bit(lanes, [&](int i) {
      rest_.places[rest_.pairs.count] = first + i;
      copy_corners<corners_of(course)>(in, first + i, rest_.pairs, rest_.pairs.count++);
    });
  }

  void find_crossing_in_halves(int first) {
    const Batch batch = make_batch<Axes::all>(rest_.pairs, first);
    unsigned undecided = batch.left;
    if (batch.fit)
      undecided |= take(batch, tamis::find_crossing_in_halves<kind>(batch.motion, batch.part), rest_.places + first);
    for_each_bit(undecided, [&](int i) { out_.undecided[out_.undecided_count++] = rest_.places[first + i]; });
  }

  /// Writes the pairs that touch; returns the lanes that the crossing does not decide. `places`: of the lanes' pairs.
  unsigned take(const Batch& batch, const Crossing<Lanes>& crossing, const std::int32_t* places) {
    const auto c = clipped_crossing(crossing, batch.clip);
    const unsigned not_free = batch.fit & ~bits(c.is_free), touches = not_free & bits(c.touches);
    if (const unsigned in_time = touches & ~bits(c.lower > Lanes(latest_))) {
      const ContactLanes contacts(c.lower, c.upper, c.u, c.v, c.normal);
      for_each_bit(in_time, [&](int i) { out_.touching[out_.touching_count++] = {places[i], contacts.result(i)}; });
    }
    return not_free & ~touches;
  }

  const Vertices vertices_;
  const double latest_;
  AdvanceBuffer& rest_;
  LaneDecisions& out_;
};

}  // namespace tamis::TAMIS_ISA
