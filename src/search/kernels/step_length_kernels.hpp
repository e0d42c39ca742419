// Which pairs of a buffer may end a step, where each must keep a fraction of its distance.
#pragma once
#include "pair/distance/kept_gap.hpp"
#include "pair/distance/start_gap.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

/// The first test of may_end_step(), on the floats of the boxes. Most pairs need no other test, and half the memory is
/// read.
template <PairKind kind>
void leave_out_kept(const MotionView& motion, const KeepRule& rule, PairBuffer& pairs) {
  int count = 0;
  for (int first = 0; first < pairs.count; first += kFloatLanes) {
    const auto m = load_box_motion<kind>(motion, pairs, first);
    FloatLanes blur(BoxFrame::kBlur);
    if (motion.has_outliers) blur = blur + (m.separation - FloatLanes(motion.box_separation.fixed)) * FloatLanes(2.0f);
    const KeptGap<kind, FloatLanes> gap(m, FloatLanes(rule.fraction), blur);
    const auto time = load_time<FloatLanes>(pairs, first);
    const unsigned left = lanes_in_use(pairs, first, kFloatLanes) & ~bits(gap.is_kept(min(time.t_out, FloatLanes(1))));
    count += store_pairs(left, pairs, first, time, pairs, count);
  }
  pairs.count = count;
}

/// Of the pairs in `left`, bits of the lanes from `first` on, those that are proven to keep the fraction on the whole
/// step, by the same doubles as keeps_distance_until. Between long features that nearly touch, an axis in floats tilts
/// too much. Then is_kept() demands too much room.
template <PairKind kind>
unsigned kept_to_end(const MotionView& motion, const KeepRule& rule, const PairBuffer& pairs, int first,
                     unsigned left) {
  unsigned kept = 0;
  for (int low = 0; low < kFloatLanes; low += kDoubleLanes) {
    const unsigned asked = left >> low & ((1u << kDoubleLanes) - 1);
    if (!asked) continue;
    const auto m = load_motion<kind>(motion.vertices, pairs, first + low, motion.separation);
    const KeptGap<kind, DoubleLanes> gap(m, DoubleLanes(rule.fraction));
    unsigned proven = bits(gap.is_kept_to_end());
    if (asked & ~proven) proven |= bits(gap.is_kept_to_end(kTurningGapParts));
    kept |= (asked & proven) << low;
  }
  return kept;
}

/// Turning axes come first, although they cost most: they leave few of the pairs.
template <PairKind kind>
void may_end_step(const MotionView& motion, const KeepRule& rule, PairBuffer& in, PairBuffer& out) {
  leave_out_kept<kind>(motion, rule, in);
  out.count = 0;
  for (int first = 0; first < in.count; first += kFloatLanes) {
    const auto m = load_motion_as_float<kind>(motion, in, first);
    const KeptGap<kind, FloatLanes> gap(m, FloatLanes(rule.fraction));
    const FloatLanes until = min(FloatLanes::load_unaligned(in.t_out + first), FloatLanes(1.0f));
    unsigned left = lanes_in_use(in, first, kFloatLanes) & ~bits(gap.is_kept(until));
    if (left) left &= ~bits(StartGap::exceeds<kind>(m, FloatLanes(rule.reach_per_speed)));
    if (left) left &= ~bits(gap.is_kept(until, kTurningGapParts));  // an axis turns less in each part
    if (left) left &= ~kept_to_end<kind>(motion, rule, in, first, left);
    for_each_bit(left, [&](int lane) { copy_pair(in, first + lane, out); });
  }
}

}  // namespace tamis::TAMIS_ISA
