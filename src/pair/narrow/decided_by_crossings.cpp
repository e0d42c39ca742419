// Decides one pair by one certified crossing, or by two in halves of its time, as lanes do. This is enough for most
// pairs.
#include "pair/filters/slab_clip.hpp"
#include "pair/narrow/clipped_crossing.hpp"
#include "pair/narrow/decisions.hpp"

namespace tamis {
namespace {

/// Decides the pair by one crossing in the times that the clip on the coordinate axes leaves. With all axes: by two
/// crossings in the times that the clip on all axes leaves. Nothing where that is not enough.
template <PairKind kind, SlabClip::Axes axes>
std::optional<PairResult> decided_after_clip(const PairMotion<double>& m, double latest) {
  const auto clip = SlabClip::clip<kind, axes>(m, TimeInterval<double>{0, 1});
  if (is_proven_free(clip, latest)) return PairResult{};
  if (clip.t_in == 0 && may_start_coplanar(m)) return {};
  const auto part = widened(clip);
  const auto s = clipped_crossing(
      axes == SlabClip::Axes::coordinates ? find_crossing<kind>(m, part) : find_crossing_in_halves<kind>(m, part),
      clip);
  if (s.is_free) return PairResult{};
  if (!s.touches) return {};
  return PairResult{true, Certainty::certified, s.lower, s.upper, s.u, s.v, {s.normal.x, s.normal.y, s.normal.z}};
}

template <PairKind kind>
std::optional<PairResult> decided_by_crossings(const PairMotion<double>& m, double latest) {
  const auto by_one = decided_after_clip<kind, SlabClip::Axes::coordinates>(m, latest);
  return by_one ? by_one : decided_after_clip<kind, SlabClip::Axes::all>(m, latest);
}

}  // namespace

std::optional<PairResult> decided_by_crossings(const PairInStep& pair, double latest) {
  if (is_about_distance(pair.kind, pair.separation) || !is_finite(pair.motion)) return {};
  return with_crossing_kind(pair.kind, [&](auto kind) { return decided_by_crossings<kind()>(pair.motion, latest); });
}

}  // namespace tamis
