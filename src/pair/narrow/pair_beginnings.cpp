// Decides pairs that move much farther than they and their gap are large. In the unit of the whole step, rounding makes
// points of their features, which may have met at once. So beginnings of the step are decided, until the features
// separate for good. Each is longer than the one before, and has its own units of time and length.
#include <algorithm>
#include <cmath>

#include "numbers/assert.hpp"
#include "pair/distance/axis_clip.hpp"
#include "pair/distance/closest.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/motion/polynomials.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

/// In the first beginning the pair goes 2^kDoublings times as far as it is large at the start. Each next beginning is
/// 2^kDoublings times as long as the one before. With 2^3 such steps are 0.95 times as fast, with 2^7 0.45.
constexpr int kDoublings = 5;

/// The length of the first beginning, a power of two; 1 or more where the pair does not go far.
double first_length(const PairMotion<double>& m) {
  constexpr int kLeastExponent = -1020;
  const auto at_start = [](const Moving<double>& v) { return largest(Moving<double>{v.at0, v.at0}); };
  const double size = std::max({at_start(m.e), at_start(m.f), at_start(m.d), m.separation});
  if (!(size > 0 && size < 1)) return 1;
  return std::ldexp(1, std::max(std::ilogb(size), kLeastExponent) + kDoublings);
}

/// The answer about the pair during `time` of a beginning. REQUIRES (not checked: exact): it is apart before `time`.
Decision decide_during(PairKind kind, const PairMotion<double>& beginning, const TimeInterval<double>& time) {
  const TimeInterval<double> clip = clipped(kind, beginning, time);
  const bool may_touch_at_start =
      clip.t_in == 0 && !is_about_distance(kind, beginning.separation) && may_start_coplanar(beginning);
  return may_touch_at_start ? Decision{Verdict::unsure, 0, 1} : decide_in_doubles(kind, beginning, clip);
}

/// Proven: at t=1 and for ever after, should the motion continue, the pair is farther apart than its separation.
bool is_apart_from_end(PairKind kind, const PairMotion<double>& m) {
  TAMIS_ASSERT(is_finite(m));
  return with_kind(kind, [&](auto k) {
    const auto closest = closest_points<k()>(m.e.at1, m.f.at1, m.d.at1);
    return AxisClip<k(), double>(m).recedes_along(1, closest.gap);
  });
}

/// A contact in a beginning of that length, at its times of the step; nothing where these underflow.
std::optional<Decision> in_step(const Decision& contact, double length) {
  const Decision d{Verdict::touches, contact.lower * length, contact.upper * length};
  return d.lower / length == contact.lower && d.upper / length == contact.upper ? std::optional(d) : std::nullopt;
}

}  // namespace

std::optional<Decision> decide_in_beginnings(const PairInStep& pair) {
  double from = 0;  // a time of the beginning, before which the pair is apart
  for (double length = first_length(pair.motion); length < 1; length = std::ldexp(length, kDoublings)) {
    const auto beginning = make_beginning(pair, length);
    if (!beginning) return {};
    const Decision d = decide_during(pair.kind, *beginning, {from, 1});
    if (d.verdict == Verdict::unsure) return {};
    if (d.touches()) return in_step(d, length);
    if (is_apart_from_end(pair.kind, *beginning)) return Decision{};
    from = std::ldexp(1, -kDoublings);
  }
  return {};
}

}  // namespace tamis
