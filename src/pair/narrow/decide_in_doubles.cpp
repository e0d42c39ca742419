// Decides one pair during a time in doubles. The slab clip comes first. In the times that it leaves, subdivision
// decides, or with a separation advancement.
#include <algorithm>
#include <vector>

#include "numbers/assert.hpp"
#include "pair/distance/turning_gap.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/filters/slab_clip.hpp"
#include "pair/narrow/clipped_crossing.hpp"
#include "pair/narrow/decisions.hpp"
#include "pair/narrow/first_within.hpp"
#include "pair/narrow/flat_root.hpp"

namespace tamis {
namespace {

// Limits of the work for one pair.
/// The shortest part that is cut further, and the widest bracket of a crossing that is not: fractions of the step.
constexpr double kShortestPart = 0x1p-44, kNarrowBracket = 0x1p-30;
/// The most parts that are tested, and of these the most coplanar throughout. Cutting such parts helps only NCF.
constexpr int kMostPartsOfStep = 96, kMostCoplanarParts = 2;
constexpr std::size_t kMostWaiting = 64;

/// When during a part the four points are coplanar, as far as doubles can tell.
struct Coplanarity {
  bool at_start, at_end, always;
};

Coplanarity coplanarity(const PairMotion<double>& m) {
  const auto k = coplanarity_polynomial(m);
  const double unit = m.size_d * m.size_e * m.size_f;
  const double end = error_bounds::bound(error_bounds::kCoplanarityEnd, unit);
  const double middle = error_bounds::bound(error_bounds::kCoplanarityMiddle, unit);
  const bool at_start = abs(k[0]) <= end, at_end = abs(k[3]) <= end;
  return {at_start, at_end, at_start && at_end && abs(k[1]) <= middle && abs(k[2]) <= middle};
}

/// Where to cut an undecided part: near an end where the points are coplanar, otherwise near the middle. (Contacts at
/// the very start of a step are common.)
double cut_at(const Coplanarity& points, const TimeInterval<double>& part) {
  constexpr double kNearEnd = 0.03137;  // no simple fraction, like kNearMiddle
  const double s = points.at_start == points.at_end ? kNearMiddle : points.at_start ? kNearEnd : 1 - kNearEnd;
  return (1 - s) * part.t_in + s * part.t_out;
}

/// For a pair that one crossing does not decide. The time is cut, earliest part first, until each part is proven free,
/// holds one certified crossing, or is too short for this arithmetic.
template <PairKind kind>
Decision subdivide(const PairMotion<double>& m, const TimeInterval<double>& time) {
  if (comes_to_flat_root<kind>(m, time)) return {Verdict::unsure, time.t_in, time.t_out};
  Decision decision;
  std::vector<TimeInterval<double>> parts{time};  // still to be looked at, the earliest last
  int coplanar_parts = 0;
  for (int looked_at = 0; !parts.empty(); ++looked_at) {
    const auto part = parts.back();
    parts.pop_back();
    const auto c = find_crossing<kind>(m, part);
    if (c.is_free) continue;
    if (c.touches) {
      decision.add_contact(c.lower, c.upper);
      break;
    }
    if (c.brackets && c.upper - c.lower <= kNarrowBracket) {
      decision.add_unsure(c.lower, c.upper);  // the inside test has said more than NCF could
      continue;
    }
    const auto r = restrict_to(m, part.t_in, part.t_out);
    if (Ncf::proves_free<kind>(r)) continue;
    const auto points = coplanarity(r);
    if (points.always && TurningGap<kind, double>(m).stays_apart(part, kTurningGapParts)) continue;  // K is about 0
    coplanar_parts += points.always;
    const double cut = cut_at(points, part);
    if (cut > part.t_in && cut < part.t_out && part.t_out - part.t_in > kShortestPart && looked_at < kMostPartsOfStep &&
        coplanar_parts < kMostCoplanarParts && parts.size() + 2 <= kMostWaiting)
      parts.insert(parts.end(), {{cut, part.t_out}, {part.t_in, cut}});
    else if (c.brackets)
      decision.add_unsure(c.lower, c.upper);
    else
      decision.add_unsure(part.t_in, part.t_out);
  }
  return decision;
}

/// The decision, on the times that the clip does not prove free.
Decision restricted_to(const TimeInterval<double>& clip, Decision d) {
  if (d.is_free()) return d;
  d.lower = std::max(d.lower, clip.t_in);
  d.upper = std::min(d.upper, clip.t_out);
  return d.verdict == Verdict::unsure && d.lower > d.upper ? Decision{} : d;
}

}  // namespace

TimeInterval<double> clipped(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  if (!is_finite(m)) return time;
  return with_kind(kind, [&](auto k) { return SlabClip::clip<k()>(m, time); });
}

Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time) {
  if (time.t_in > time.t_out) return {};
  if (!is_finite(m)) return {Verdict::unsure, time.t_in, time.t_out};
  TAMIS_ASSERT(is_whole(m) && is_part_of_step(time));
  if (is_about_distance(kind, m.separation)) return first_within(kind, m, time);
  return with_crossing_kind(kind, [&](auto k) { return restricted_to(time, subdivide<k()>(m, widened(time))); });
}

}  // namespace tamis
