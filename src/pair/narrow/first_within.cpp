#include "pair/narrow/first_within.hpp"

#include <algorithm>
#include <optional>

#include "numbers/assert.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/advancement.hpp"

namespace tamis {
namespace {

/// Probes of one pair. Newton's method needs 3 to 8. A near miss by 1e-15 of the pair's size needs about 40.
constexpr int kMaxProbes = 160;
/// Probes that advance by at least this part of the step do not count. While a pair's clearance exceeds
/// error_bounds::kAdvanceClearance of its size, all probes advance that far.
constexpr double kLeastProgress = error_bounds::kAdvanceClearance / 16;

/// Advances through the step from its start. Until `at_.now` everything is decided.
template <PairKind kind>
class Advance {
 public:
  Advance(const PairMotion<double>& m, const TimeInterval<double>& time)
      : probe_(m), end_(time.t_out), at_{time.t_in} {}

  Decision run() {
    for (int probes = 0; probes < kMaxProbes && at_.now <= end_;) {
      const double before = at_.now, t = std::min(before + at_.ahead, end_);
      const DistanceAt<double> distance = probe_.distance_at(t);
      if (probe_.touches(distance)) {
        decision_.add_contact(at_.now, t);
        return decision_;
      }
      const ApartProof<double> proof = probe_.prove_apart(t, distance);
      if (proof.until > t)
        advance(proof, t);
      else
        retry_later(proof, t);
      if (at_.now - before < kLeastProgress) ++probes;
    }
    if (at_.now <= end_) add_unsure(end_);
    return decision_;
  }

 private:
  /// The pair is proven apart at `t`: all is decided up to the end of the proof, but for a gap that may precede it.
  void advance(const ApartProof<double>& proof, double t) {
    const double since = t > at_.now ? probe_.clip().apart_since(t, proof.axis) : t;
    if (t > at_.now && since >= at_.now) {
      beyond_ = {since, proof.until};
      at_.ahead = 0.5 * (since - at_.now);
      if (at_.ahead > kShortestAdvance) return;
      add_unsure(since);
    }
    at_.advance(true, proof);
    beyond_.reset();
  }

  /// Doubles cannot tell at `t`: probes later, until the answer is clear.
  void retry_later(const ApartProof<double>& proof, double t) {
    if (beyond_) {
      add_unsure(beyond_->t_in);
      continue_at(beyond_->t_out);
    } else if (t >= end_) {
      add_unsure(end_);
      continue_at(2);
    } else {
      at_.retry_later(true, proof);
    }
  }

  void continue_at(double until) {
    at_ = {until};
    beyond_.reset();
  }

  /// Calls come in the order of time.
  void add_unsure(double until) { decision_.add_unsure(at_.now, until); }

  const SeparationProbe<kind, double> probe_;
  const double end_;
  Advancement<double> at_;
  std::optional<TimeInterval<double>> beyond_;  ///< proven apart, after a gap from at_.now on that is undecided
  Decision decision_;
};

/// A time until which the pair is proven apart from `now` on. No later than `now` if nothing is proven. Rounding tilts
/// the axis of a gap that is tiny beside its features, differently at each time. So times a little later are tried.
template <PairKind kind>
double apart_from(const SeparationProbe<kind, double>& probe, double separation, double now) {
  constexpr double kClearlyApart = 1 + 0x1p-10;
  const DistanceAt<double> distance = probe.distance_at(now);
  if (probe.touches(distance)) return now;
  double proven = probe.prove_apart(now, distance).until;
  if (!(distance.length > kClearlyApart * separation)) return proven;
  for (double part = 0x1p-20; !(proven > now) && part < 0x1p-4; part *= 4) {
    const double later = std::min(now * (1 + part), 1.0);  // error bounds hold for times in the step
    const ApartProof<double> proof = probe.prove_apart(later, probe.distance_at(later));
    if (proof.until > later && probe.clip().apart_since(later, proof.axis) <= now) proven = proof.until;
  }
  return proven;
}

template <PairKind kind>
double apart_until(const PairMotion<double>& m, double from, double until) {
  const SeparationProbe<kind, double> probe(m);
  double now = from;
  for (int probes = 0; probes < kMaxProbes && now < until;) {
    const double proven = apart_from(probe, m.separation, now), progress = proven - now;
    if (!(progress > 0)) break;
    now = proven;
    if (progress <= 0x1p-40 * now) break;
    if (progress < kLeastProgress) ++probes;
  }
  return std::min(now, 1.0);
}

}  // namespace

Decision first_within(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  TAMIS_ASSERT(is_part_of_step(time));
  return with_kind(kind, [&](auto k) { return Advance<k()>(m, time).run(); });
}

double apart_until(PairKind kind, const PairMotion<double>& m, double from, double until) {
  TAMIS_ASSERT(0 <= from && from <= 1 && until <= 1);
  return with_kind(kind, [&](auto k) { return apart_until<k()>(m, from, until); });
}

}  // namespace tamis
