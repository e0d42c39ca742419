#include "narrow/decide_in_doubles.hpp"

#include <algorithm>

#include "filters/slab_clip.hpp"
#include "narrow/decided_by_crossing.hpp"
#include "narrow/separation.hpp"
#include "narrow/subdivide.hpp"

namespace tamis {
namespace {

/// The decision without what the clip proves free.
Decision within(const TimeInterval<double>& clip, Decision d) {
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
  return is_about_distance(kind, m.separation) ? first_within(kind, m, time)
                                               : within(time, subdivide(kind, m, widened(time)));
}

}  // namespace tamis
