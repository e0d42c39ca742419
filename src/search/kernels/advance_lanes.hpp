// The times when pairs come within their separation. Each pair takes as many steps of conservative advancement as it
// needs (pair/narrow/advancement.hpp). After each step the remaining pairs are compacted. So no lane waits for the
// slowest. Undecided pairs then take the same steps one at a time (pair/narrow/first_within.hpp), with the same bits.
#pragma once
#include <limits>

#include "pair/distance/rest_distance.hpp"
#include "pair/filters/slab_clip.hpp"
#include "pair/narrow/advancement.hpp"
#include "pair/narrow/sharp_bracket.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/contact_lanes.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

template <PairKind kind, class Vertices>
class AdvanceLanes {
 public:
  /// Pairs whose contact begins after `latest` count as free.
  AdvanceLanes(Vertices vertices, const PairSeparation<double>& separation, double latest, DecisionScratch& scratch,
               LaneDecisions& out)
      : vertices_(vertices),
        separation_(separation),
        latest_(latest),
        moving_(scratch.moving),
        touching_(scratch.touching),
        out_(out) {}

  void run(const PairBuffer& in) {
    moving_.pairs.count = touching_.pairs.count = 0;
    for (int first = 0; first < in.count; first += kDoubleLanes) start(in, first);
    for (int probes = 1; moving_.pairs.count > 0 && probes < kMaxProbes; ++probes) probe_again();
    for (int i = 0; i < moving_.pairs.count; ++i) leave_undecided(moving_.places[i]);
    for (int first = 0; first < touching_.pairs.count; first += kDoubleLanes) describe(first);
  }

 private:
  using Lanes = DoubleLanes;
  /// The few pairs that need more probes are decided one by one.
  static constexpr int kMaxProbes = 24;

  PairMotion<Lanes> load(const PairBuffer& pairs, int first) const {
    return load_motion<kind>(vertices_, pairs, first, separation_);
  }

  void start(const PairBuffer& in, int first) {
    const auto m = load(in, first);
    const unsigned all = lanes_in_use(in, first);
    unsigned fit = all & finite_lanes(m);
    if constexpr (can_cross(kind)) fit &= bits(m.separation > Lanes(0));  // 0: none, or one that underflows
    const auto clip = SlabClip::clip<kind>(m, TimeInterval<Lanes>{Lanes(0), Lanes(1)});
    const unsigned free = fit & bits((clip.t_in > clip.t_out) | (clip.t_in > Lanes(latest_)));
    std::int32_t places[kDoubleLanes];
    for (int i = 0; i < kDoubleLanes; ++i) places[i] = first + i;
    for_each_bit(all & ~fit, [&](int i) { leave_undecided(places[i]); });
    if (fit & ~free) probe(in, first, places, m, clip.t_in, clip.t_out, fit & ~free);
  }

  void probe_again() {
    PairBuffer& pairs = moving_.pairs;
    const int count = pairs.count;
    pairs.count = 0;
    for (int first = 0; first < count; first += kDoubleLanes) {
      std::int32_t places[kDoubleLanes];  // a copy: pairs that go on overwrite this batch
      for (int i = 0; i < kDoubleLanes; ++i) places[i] = moving_.places[first + i];
      const Lanes now = Lanes::load_unaligned(moving_.now + first), end = Lanes::load_unaligned(moving_.until + first);
      probe(pairs, first, places, load(pairs, first), now, end, first_lanes(count - first));
    }
  }

  /// One step of advancement from the times `now`, for the pairs first, first + 1, ... of a buffer.
  void probe(const PairBuffer& pairs, int first, const std::int32_t* places, const PairMotion<Lanes>& m,
             const Lanes& now, const Lanes& end, unsigned lanes) {
    const SeparationProbe<kind, Lanes> separation(m);
    const DistanceAt<Lanes> distance = separation.distance_at(now);
    const unsigned touches = lanes & bits(separation.touches(distance));
    append(pairs, first, touches, places, now, now, touching_);
    lanes &= ~touches;
    if (!lanes) return;
    const ApartProof<Lanes> proof = separation.prove_apart(now, distance);
    const auto is_apart = proof.until > now;
    Advancement<Lanes> next{now};
    next.advance(is_apart, proof);
    next.retry_later(!is_apart, proof);
    const unsigned apart = lanes & bits(is_apart), undecided = lanes & ~apart & bits(now >= end);
    const unsigned free = apart & bits((next.now > end) | (next.now > Lanes(latest_)));
    const unsigned goes_on = apart & ~free & bits(next.ahead == Lanes(0));
    for_each_bit(undecided, [&](int i) { leave_undecided(places[i]); });
    append(pairs, first, lanes & ~free & ~goes_on & ~undecided, places, next.now, min(next.now + next.ahead, end),
           touching_);
    append(pairs, first, goes_on, places, next.now, end, moving_);  // last: it may overwrite `pairs`
  }

  static void append(const PairBuffer& from, int first, unsigned lanes, const std::int32_t* places, const Lanes& now,
                     const Lanes& until, AdvanceBuffer& to) {
    double times[2][kDoubleLanes];
    now.store_unaligned(times[0]);
    until.store_unaligned(times[1]);
    for_each_bit(lanes, [&](int i) {
      int& count = to.pairs.count;
      copy_corners(from, first + i, to.pairs, count);
      to.places[count] = places[i];
      to.now[count] = times[0][i];
      to.until[count] = times[1][i];
      ++count;
    });
  }

  /// Decides pairs that should touch by their time `until`, and describes their contacts.
  void describe(int first) {
    const unsigned lanes = lanes_in_use(touching_.pairs, first);
    const Lanes lower = Lanes::load_unaligned(touching_.now + first);
    const Lanes upper = Lanes::load_unaligned(touching_.until + first);
    const auto m = load(touching_.pairs, first);
    const auto place = direction_apart<kind>(m, lower);
    const unsigned late = lanes & bits(lower > Lanes(latest_));
    const SeparationProbe<kind, Lanes> separation(m);
    const auto touches = separation.touches(separation.distance_at(upper));
    const unsigned decided = lanes & ~late & bits(touches & is_sharp(lower, upper));
    const Lanes unknown(std::numeric_limits<double>::quiet_NaN());
    const Vec3<Lanes> normal = select(place.is_sure, place.direction, Vec3<Lanes>{unknown, unknown, unknown});
    const ContactLanes contacts(lower, upper, place.u, place.v, normal);
    const std::int32_t* places = touching_.places + first;
    for_each_bit(lanes & ~late & ~decided, [&](int i) { leave_undecided(places[i]); });
    for_each_bit(decided, [&](int i) {
      if (!contacts.has_place(i)) return leave_undecided(places[i]);  // integers find it
      out_.touching[out_.touching_count++] = {places[i], contacts.result(i)};
    });
  }

  void leave_undecided(std::int32_t place) { out_.undecided[out_.undecided_count++] = place; }

  const Vertices vertices_;
  const PairSeparation<double> separation_;
  const double latest_;
  AdvanceBuffer &moving_, &touching_;
  LaneDecisions& out_;
};

}  // namespace tamis::TAMIS_ISA
