// Proves that features which come closer all the time, even to one line or point, stay apart until a time before that.
#include <array>

#include "pair/distance/collapsing_gap.hpp"
#include "pair/distance/turning_gap.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

constexpr std::size_t kMostTries = 12;

/// Half of the time is tried where all of it is too long for one axis. A pair that closes in turns ever faster.
template <PairKind kind>
bool stays_apart(const PairMotion<double>& m, const TimeInterval<double>& time) {
  const TurningGap<kind, double> gap(m);
  const auto at = [&](double t) {
    return gap.axis(t, CollapsingGap::gap<kind>(at_time(m.e, t), at_time(m.f, t), at_time(m.d, t)));
  };
  const double least = gap.least();
  auto from = at(time.t_in);
  std::array<decltype(from), kMostTries + 1> until{at(time.t_out)};  // still to be reached, the first one last
  std::size_t count = 1;
  for (std::size_t tries = 0; tries < kMostTries && count > 0; ++tries) {
    const auto next = until[count - 1];
    if (gap.exceeds(least, from, next)) {
      from = next;
      --count;
    } else {
      until[count++] = at(0.5 * (from.time + next.time));
    }
  }
  return count == 0;
}

}  // namespace

bool stays_apart_closing_in(const PairInStep& pair, const TimeInterval<double>& time) {
  return is_finite(pair.motion) &&
         with_kind(pair.kind, [&](auto kind) { return stays_apart<kind()>(pair.motion, time); });
}

}  // namespace tamis
