// The stages in lanes over a buffer of pairs that may cross: slab clip, DNF, NCF and the solver of one crossing.
#pragma once
#include "pair/filters/dnf.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/filters/slab_clip.hpp"
#include "pair/narrow/clipped_crossing.hpp"
#include "search/kernels/compress.hpp"
#include "search/kernels/contact_lanes.hpp"
#include "search/kernels/crossings.hpp"
#include "search/kernels/load_motion.hpp"

namespace tamis::TAMIS_ISA {

/// How many corners a pair in a buffer has.
constexpr int corners_of(Course course) { return course == Course::along_edge ? 5 : 4; }

/// The slab clip, in floats: its times need not be sharp, and twice as many pairs fit into the lanes.
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
    ncf_count += __builtin_popcount(left);
    left &= ~bits(Ncf::proves_free<kind>(m));
    for_each_bit(left, [&](int lane) { copy_pair(in, first + lane, out); });
  }
  return ncf_count;
}

/// Writes the lanes of `left` to `out`; `pairs` names each lane's pair. Returns the new number of entries.
inline int write_solved(const Crossing<DoubleLanes>& crossing, const TimeInterval<DoubleLanes>& part, unsigned left,
                        const std::int32_t* pairs, SolvedPair* out, int count) {
  const auto c = clipped_crossing(crossing, part);
  const ContactLanes contacts(c.lower, c.upper, c.u, c.v, c.normal);
  const unsigned touches = bits(c.touches);
  for_each_bit(left, [&](int i) { out[count++] = SolvedPair{pairs[i], (touches >> i & 1) != 0, contacts.result(i)}; });
  return count;
}

/// Looks for one crossing in each pair's time. Pairs that stay undecided go to `rest`, and are searched again in two
/// halves of their time.
template <PairKind kind, Course course = Course::step>
int solve(const MotionView& motion, const PairBuffer& in, PairBuffer& rest, SolvedPair* out) {
  std::int32_t pairs[kDoubleLanes], rest_pairs[PairBuffer::kSize];
  int count = 0;
  rest.count = 0;
  const auto make = [&](int first) {
    return CrossingBatch{first, lanes_in_use(in, first), load_motion<kind, course>(motion.vertices, in, first),
                         load_time<DoubleLanes>(in, first)};
  };
  for_each_crossing<kind>(in.count, make, [&](const CrossingBatch& batch, const Crossing<DoubleLanes>& c) {
    const unsigned left = batch.lanes & ~bits(c.is_free), touches = left & bits(c.touches);
    for (int i = 0; i < kDoubleLanes; ++i) pairs[i] = batch.first + i;
    if (touches) count = write_solved(c, batch.part, touches, pairs, out, count);
    for_each_bit(left & ~touches, [&](int i) {
      rest_pairs[rest.count] = batch.first + i;
      copy_pair(in, batch.first + i, rest);
    });
  });
  for (int first = 0; first < rest.count; first += kDoubleLanes) {
    const auto part = load_time<DoubleLanes>(rest, first);
    const auto c = find_crossing_in_halves<kind>(load_motion<kind, course>(motion.vertices, rest, first), part);
    const unsigned left = lanes_in_use(rest, first) & ~bits(c.is_free);
    if (left) count = write_solved(c, part, left, rest_pairs + first, out, count);
  }
  return count;
}

}  // namespace tamis::TAMIS_ISA
