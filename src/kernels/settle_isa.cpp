// The pairs of a list: compiled once for each instruction set. What is asked of a pair here is asked of it in decide()
// too, in the same order, so that it has the same bits.
#include "kernels/advance_lanes.hpp"
#include "kernels/crossings.hpp"
#include "kernels/load_motion.hpp"
#include "kernels/search.hpp"
#include "kernels/settle.hpp"
#include "narrow/settled.hpp"

namespace tamis::TAMIS_ISA {
namespace {

using Axes = SlabClip::Axes;

/// The pairs first, first + 1, ... of `pairs`, whose places in the list of results are `places`; clipped.
template <PairKind kind, Axes axes>
struct ClippedStride : CrossingStride {
  ClippedStride(const ListedPairs& list, const PairBuffer& pairs, const std::int32_t* all_places, int at)
      : CrossingStride{at,
                       lanes_in_use(pairs, at),
                       load_motion<kind>(list.vertices, pairs, at, {list.options.min_separation, false}),
                       {}},
        places(all_places + at),
        clip(SlabClip::clip<kind, axes>(motion, TimeInterval<DoubleLanes>{DoubleLanes(0), DoubleLanes(1)})) {
    part = widened(clip);
    finite = finite_lanes(motion);
    free = lanes & finite & bits((clip.t_in > clip.t_out) | (clip.t_in > DoubleLanes(list.options.latest)));
    lanes &= ~free;
  }
  /// Lanes that a crossing may settle.
  unsigned may_be_settled() const { return finite & ~bits((clip.t_in == DoubleLanes(0)) & may_start_coplanar(motion)); }

  const std::int32_t* places;
  TimeInterval<DoubleLanes> clip;
  unsigned finite, free;  ///< bits of lanes
};

template <PairKind kind>
class Settling {
 public:
  Settling(const ListedPairs& list, PairBuffer& rest, PairResult* results, std::int32_t* open)
      : list_(list), rest_(rest), results_(results), open_(open) {
    rest.count = 0;
  }

  /// Returns how many pairs are left open.
  int run(const PairBuffer& in) {
    if constexpr (can_cross(kind))
      if (list_.options.min_separation == 0) return find_crossings(in);
    const WithinRule rule{{list_.options.min_separation, false}, list_.options.latest};
    AdvanceLanes<kind, StepRows, Settling>(list_.vertices, rule, *list_.within, *this).run(in);
    return open_count_;
  }

  // Of pairs within a separation.
  void free(int i) { results_[list_.places[i]] = {}; }
  void open(int i) { open_[open_count_++] = list_.places[i]; }
  void touches(int i, const TouchingLanes& t, int lane) {
    results_[list_.places[i]] = {true,
                                 Certainty::certified,
                                 t.lower[lane],
                                 t.upper[lane],
                                 t.u[lane],
                                 t.v[lane],
                                 {t.x[lane], t.y[lane], t.z[lane]}};
  }

 private:
  int find_crossings(const PairBuffer& in) {
    using Stride = ClippedStride<kind, Axes::coordinates>;
    const auto make = [&](int first) {
      Stride stride(list_, in, list_.places, first);
      keep_free(stride.free, stride.places);
      const unsigned fit = stride.lanes & stride.may_be_settled();
      try_again(stride.lanes & ~fit, in, stride);
      stride.lanes = fit;
      return stride;
    };
    for_each_crossing<kind>(in.count, make, [&](const Stride& stride, const Crossing<DoubleLanes>& crossing) {
      try_again(unsettled(stride, crossing), in, stride);
    });
    for (int first = 0; first < rest_.count; first += kDoubleLanes) look_in_halves(first);
    return open_count_;
  }

  template <class Stride>
  void try_again(unsigned lanes, const PairBuffer& in, const Stride& stride) {
    for_each_bit(lanes, [&](int i) {
      rest_places_[rest_.count] = stride.places[i];
      for (int corner = 0; corner < 4; ++corner)
        rest_.corner[corner][rest_.count] = in.corner[corner][stride.first + i];
      ++rest_.count;
    });
  }

  void look_in_halves(int first) {
    ClippedStride<kind, Axes::all> stride(list_, rest_, rest_places_, first);
    keep_free(stride.free, stride.places);
    const unsigned fit = stride.lanes & stride.may_be_settled();
    leave_open(stride.lanes & ~fit, stride.places);
    stride.lanes = fit;
    if (!fit) return;
    const auto crossing = find_crossing_in_halves<kind>(stride.motion, stride.part);
    leave_open(unsettled(stride, crossing), stride.places);
  }

  void keep_free(unsigned lanes, const std::int32_t* places) {
    for_each_bit(lanes, [&](int i) { results_[places[i]] = {}; });
  }
  void leave_open(unsigned lanes, const std::int32_t* places) {
    for_each_bit(lanes, [&](int i) { open_[open_count_++] = places[i]; });
  }

  /// Writes what the crossing settles of the stride; returns the lanes that it does not.
  template <Axes axes>
  unsigned unsettled(const ClippedStride<kind, axes>& stride, const Crossing<DoubleLanes>& crossing) {
    const auto s = settled(crossing, stride.clip);
    const unsigned lanes = stride.lanes;
    const unsigned free = lanes & bits(s.is_free), touches = lanes & ~free & bits(s.touches);
    const unsigned late = touches & bits(s.lower > DoubleLanes(list_.options.latest));
    keep_free(free | late, stride.places);
    const DoubleLanes fields[] = {s.lower, s.upper, s.u, s.v, s.normal.x, s.normal.y, s.normal.z};
    double f[7][kDoubleLanes];
    for (int k = 0; k < 7; ++k) fields[k].store_unaligned(f[k]);
    for_each_bit(touches & ~late, [&](int i) {
      results_[stride.places[i]] = {true,    Certainty::certified,       f[0][i], f[1][i], f[2][i],
                                    f[3][i], {f[4][i], f[5][i], f[6][i]}};
    });
    return lanes & ~free & ~touches;
  }

  const ListedPairs& list_;
  PairBuffer& rest_;
  PairResult* results_;
  std::int32_t* open_;
  std::int32_t rest_places_[PairBuffer::kSize];
  int open_count_ = 0;
};

}  // namespace

template <PairKind kind>
int settle(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results, std::int32_t* open) {
  return Settling<kind>(list, rest, results, open).run(in);
}

#define TAMIS_SETTLE(kind) \
  template int settle<PairKind::kind>(const ListedPairs&, const PairBuffer&, PairBuffer&, PairResult*, std::int32_t*)
TAMIS_SETTLE(vertex_face);
TAMIS_SETTLE(edge_edge);
TAMIS_SETTLE(vertex_edge);
TAMIS_SETTLE(vertex_vertex);

}  // namespace tamis::TAMIS_ISA
