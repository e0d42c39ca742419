// The filters in lanes over a buffer of pairs that may cross: slab clip, DNF and NCF.
#pragma once
#include "pair/filters/dnf.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/filters/slab_clip.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

/// The slab clip, in floats. Its times need not be sharp, and twice as many pairs fit into the lanes.
template <PairKind kind, Course course = Course::step>
void slab(const MotionView& motion, const PairBuffer& in, PairBuffer& out) {
  out.count = 0;
  for (int first = 0; first < in.count; first += kFloatLanes) {
    const auto time =
        SlabClip::clip<kind>(load_box_motion<kind, course>(motion, in, first), load_time<FloatLanes>(in, first));
    const unsigned left = bits(time.t_in <= time.t_out) & lanes_in_use(in, first, kFloatLanes);
    out.count += store_pairs<corners_of(course)>(left, in, first, time, out, out.count);
  }
}

template <PairKind kind, Course course = Course::step>
int filter(const MotionView& motion, const PairBuffer& in, PairBuffer& out) {
  int ncf_count = 0;
  out.count = 0;
  for (int first = 0; first < in.count; first += kDoubleLanes) {
    const auto time = load_time<DoubleLanes>(in, first);
    const auto m = restrict_to(load_motion<kind, course>(motion.vertices, in, first), time.t_in, time.t_out);
    unsigned left = lanes_in_use(in, first) & ~bits(Dnf::proves_free<kind>(m));
    if (!left) continue;
    ncf_count += count_bits(left);
    left &= ~bits(Ncf::proves_free<kind>(m));
    for_each_bit(left, [&](int lane) { copy_pair(in, first + lane, out); });
  }
  return ncf_count;
}

}  // namespace tamis::TAMIS_ISA
