// All kernels of one instruction set: this file is compiled once for each.
#include <cstring>

#include "distance/kept_gap.hpp"
#include "distance/start_gap.hpp"
#include "filters/dnf.hpp"
#include "filters/ncf.hpp"
#include "filters/slab_clip.hpp"
#include "kernels/bound_leaf.hpp"
#include "kernels/clearance_boxes.hpp"
#include "kernels/compress.hpp"
#include "kernels/contact_lanes.hpp"
#include "kernels/crossings.hpp"
#include "kernels/isa_declarations.hpp"
#include "kernels/keep_boxes.hpp"
#include "kernels/load_motion.hpp"
#include "kernels/rest_kernels.hpp"
#include "kernels/search.hpp"
#include "kernels/split.hpp"
#include "narrow/decided_by_crossing.hpp"

namespace tamis::TAMIS_ISA {
namespace {

template <PairKind kind, class Boxes, Course course = Course::step>
void search(Search& state, int block) {
  BlockSearch<kind, Boxes, course>(state, block).run();
}

template <PairKind kind>
void search_step_ends(Search& state, int block) {
  if (moves_little(state, block))
    BlockSearch<kind, ClearanceBoxes>(state, block).run();
  else
    BlockSearch<kind, KeepBoxes>(state, block).run();
}

void copy_pair(const PairBuffer& in, int from, PairBuffer& out) {
  copy_corners<5>(in, from, out, out.count);
  out.t_in[out.count] = in.t_in[from];
  out.t_out[out.count] = in.t_out[from];
  ++out.count;
}

/// How many corners a pair in a buffer has.
constexpr int corners_of(Course course) { return course == Course::along_edge ? 5 : 4; }

/// In floats: the times need not be sharp here, and twice as many pairs fit.
template <PairKind kind, Course course = Course::step>
void slab(const BoxVertex* vertices, const BoxSeparation& separation, const PairBuffer& in, PairBuffer& out) {
  for (int first = 0; first < in.count; first += kFloatLanes) {
    const auto time = SlabClip::clip<kind>(load_box_motion<kind, course>(vertices, in, first, separation),
                                           load_time<FloatLanes>(in, first));
    const unsigned left = bits(time.t_in <= time.t_out) & lanes_in_use(in, first, kFloatLanes);
    out.count += store_pairs<corners_of(course)>(left, in, first, time, out, out.count);
  }
}

/// The first test of may_end_step(), on the floats of the boxes: half the memory to read for most of the pairs.
template <PairKind kind>
void leave_out_kept(const BoxVertex* vertices, const BoxSeparation& separation, const KeepRule& rule,
                    PairBuffer& pairs) {
  int count = 0;
  for (int first = 0; first < pairs.count; first += kFloatLanes) {
    const auto m = load_box_motion<kind>(vertices, pairs, first, separation);
    const KeptGap<kind, FloatLanes> gap(m, FloatLanes(rule.fraction), FloatLanes(BoxFrame::kBlur));
    const auto time = load_time<FloatLanes>(pairs, first);
    const unsigned left = lanes_in_use(pairs, first, kFloatLanes) & ~bits(gap.is_kept(min(time.t_out, FloatLanes(1))));
    count += store_pairs(left, pairs, first, time, pairs, count);
  }
  pairs.count = count;
}

/// Turning axes come first, although they cost most: they leave few of the pairs.
template <PairKind kind>
void may_end_step(const KeepVertices& vertices, const KeepRule& rule, PairBuffer& in, PairBuffer& out) {
  leave_out_kept<kind>(vertices.in_boxes, vertices.box_separation, rule, in);
  for (int first = 0; first < in.count; first += kFloatLanes) {
    const auto m = load_motion_as_float<kind>(vertices.exact, in, first, vertices.separation);
    const KeptGap<kind, FloatLanes> gap(m, FloatLanes(rule.fraction));
    const FloatLanes until = min(FloatLanes::load_unaligned(in.t_out + first), FloatLanes(1.0f));
    unsigned left = lanes_in_use(in, first, kFloatLanes) & ~bits(gap.is_kept(until));
    if (left) left &= ~bits(StartGap::exceeds<kind>(m, FloatLanes(rule.reach_per_speed)));
    if (left) left &= ~bits(gap.is_kept(until, kTurningGapParts));  // axes turn less in each
    for_each_bit(left, [&](int lane) { copy_pair(in, first + lane, out); });
  }
}

template <PairKind kind, Course course = Course::step>
int filter(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& out) {
  int ncf_count = 0;
  for (int first = 0; first < in.count; first += kDoubleLanes) {
    const auto time = load_time<DoubleLanes>(in, first);
    const auto m = restrict_to(load_motion<kind, course>(vertices, in, first), time.t_in, time.t_out);
    unsigned left = lanes_in_use(in, first) & ~bits(Dnf::proves_free<kind>(m));
    if (!left) continue;
    ncf_count += __builtin_popcount(left);
    left &= ~bits(Ncf::proves_free<kind>(m));
    for_each_bit(left, [&](int lane) { copy_pair(in, first + lane, out); });
  }
  return ncf_count;
}

template <PairKind kind>
void filter_deviating(const PackedVertex* vertices, double deviation, const PairBuffer& in, PairBuffer& out) {
  for (int first = 0; first < in.count; first += kDoubleLanes) {
    const auto time = load_time<DoubleLanes>(in, first);
    const auto whole = load_motion<kind>(vertices, in, first, {deviation, false});  // scaled as the motion is
    const auto m = restrict_to(whole, time.t_in, time.t_out);
    const auto free = Dnf::proves_free_though_deviating<kind>(m, whole.separation);
    for_each_bit(lanes_in_use(in, first) & ~bits(free), [&](int lane) { copy_pair(in, first + lane, out); });
  }
}

/// Writes the lanes of `left` to `out`; `pairs` names each lane's pair. Returns the new number of entries.
int write_solved(const Crossing<DoubleLanes>& crossing, const TimeInterval<DoubleLanes>& part, unsigned left,
                 const std::int32_t* pairs, SolvedPair* out, int count) {
  const auto c = decided_by_crossing(crossing, part);
  const ContactLanes contacts(c.lower, c.upper, c.u, c.v, c.normal);
  const unsigned touches = bits(c.touches);
  for_each_bit(left, [&](int i) { out[count++] = contacts.solved(pairs[i], touches >> i & 1, i); });
  return count;
}

/// One crossing first; pairs that it leaves undecided go to `rest`, and are searched in two halves of their time.
template <PairKind kind, Course course = Course::step>
int solve(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& rest, SolvedPair* out) {
  std::int32_t pairs[kDoubleLanes], rest_pairs[PairBuffer::kSize];
  int count = 0;
  rest.count = 0;
  const auto make = [&](int first) {
    return CrossingBatch{first, lanes_in_use(in, first), load_motion<kind, course>(vertices, in, first),
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
    const auto c = find_crossing_in_halves<kind>(load_motion<kind, course>(vertices, rest, first), part);
    const unsigned left = lanes_in_use(rest, first) & ~bits(c.is_free);
    if (left) count = write_solved(c, part, left, rest_pairs + first, out, count);
  }
  return count;
}

constexpr auto kVf = PairKind::vertex_face, kEe = PairKind::edge_edge;

template <PairKind kind>
constexpr PairKernels kernels_of() {
  constexpr PairKind kSearched = kind == kEe ? kEe : kVf;
  PairKernels kernels{.search = search<kSearched, MovingBoxes>,
                      .search_at_rest = search<kSearched, RestBoxes>,
                      .search_step_ends = search_step_ends<kSearched>,
                      .slab = slab<kind>,
                      .cull_apart = cull_apart<kind>,
                      .come_within = come_within<kind>,
                      .find_within_at_rest = find_within_at_rest<kind>,
                      .measure = measure<kind>,
                      .decide_list = decide_list<kind>};
  if constexpr (can_cross(kind)) {
    kernels.may_end_step = may_end_step<kind>;
    kernels.filter = filter<kind>;
    kernels.filter_deviating = filter_deviating<kind>;
    kernels.solve = solve<kind>;
  }
  return kernels;
}

constexpr PairKernels kAlongEdges{.search = search<kVf, RestBoxes, Course::along_edge>,
                                  .slab = slab<kVf, Course::along_edge>,
                                  .filter = filter<kVf, Course::along_edge>,
                                  .solve = solve<kVf, Course::along_edge>};

}  // namespace

static_assert(kPairKinds == 4, "name the kernels of each kind below");
extern const Kernels kKernels;
constinit const Kernels kKernels{
    Isa::TAMIS_ISA,
    {split, bound_leaf},
    {kernels_of<kVf>(), kernels_of<kEe>(), kernels_of<PairKind::vertex_edge>(), kernels_of<PairKind::vertex_vertex>()},
    kAlongEdges};

}  // namespace tamis::TAMIS_ISA
