// The pairs of a list: compiled once for each instruction set. What is asked of a pair here is asked of it in decide()
// too, in the same order, so that it has the same bits.
#include "kernels/load_motion.hpp"
#include "kernels/search.hpp"
#include "kernels/settle.hpp"
#include "solve/settled.hpp"

namespace tamis::TAMIS_ISA {
namespace {

/// Of all components: not finite if one is not.
DoubleLanes sum(const Moving<DoubleLanes>& v) { return (v.at0.x + v.at0.y + v.at0.z) + (v.at1.x + v.at1.y + v.at1.z); }

using Axes = SlabClip::Axes;

/// As many pairs as there are lanes.
template <PairKind kind, Axes axes>
struct Clipped {
  Clipped(const ListedPairs& list, const PairBuffer& pairs, int first)
      : motion(load_motion<kind>(list.vertices, pairs, first, {list.options.min_separation, false})),
        time(SlabClip::clip<kind, axes>(motion, TimeInterval<DoubleLanes>{DoubleLanes(0), DoubleLanes(1)})) {
    const DoubleLanes all = sum(motion.e) + sum(motion.f) + sum(motion.d);
    finite = bits(all - all == DoubleLanes(0));  // NOLINT(misc-redundant-expression): NaN where all is not finite
    free = finite & bits((time.t_in > time.t_out) | (time.t_in > DoubleLanes(list.options.latest)));
  }
  unsigned starts_coplanar() const { return bits((time.t_in == DoubleLanes(0)) & may_start_coplanar(motion)); }

  PairMotion<DoubleLanes> motion;
  TimeInterval<DoubleLanes> time;
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
    for (int first = 0; first < in.count; first += kDoubleLanes) {
      const Clipped<kind, Axes::all> c(list_, in, first);
      const unsigned pairs = lanes_in_use(in, first);
      keep_free(pairs & c.free, list_.places + first);
      leave_open(pairs & ~c.free, list_.places + first);
    }
    return open_count_;
  }

 private:
  int find_crossings(const PairBuffer& in) {
    for (int first = 0; first < in.count; first += kDoubleLanes) look_for_one(in, first);
    for (int first = 0; first < rest_.count; first += kDoubleLanes) look_in_halves(first);
    return open_count_;
  }

  void look_for_one(const PairBuffer& in, int first) {
    const Clipped<kind, Axes::coordinates> c(list_, in, first);
    const std::int32_t* places = list_.places + first;
    const unsigned pairs = lanes_in_use(in, first), left = pairs & ~c.free;
    const unsigned crossing = left & c.finite & ~(is_exact_ ? c.starts_coplanar() : 0);
    keep_free(pairs & c.free, places);
    leave_open(left & ~crossing, places);
    if (!crossing) return;
    for_each_bit(unsettled(c, crossing, places, find_crossing<kind>(c.motion, widened(c.time))), [&](int i) {
      rest_places_[rest_.count] = places[i];
      for (int corner = 0; corner < 4; ++corner) rest_.corner[corner][rest_.count] = in.corner[corner][first + i];
      ++rest_.count;
    });
  }

  void look_in_halves(int first) {
    const Clipped<kind, Axes::all> c(list_, rest_, first);
    const std::int32_t* places = rest_places_ + first;
    const unsigned pairs = lanes_in_use(rest_, first), left = pairs & ~c.free;
    keep_free(pairs & c.free, places);
    if (left) leave_open(unsettled(c, left, places, find_crossing_in_halves<kind>(c.motion, widened(c.time))), places);
  }

  void keep_free(unsigned lanes, const std::int32_t* places) {
    for_each_bit(lanes, [&](int i) { results_[places[i]] = {}; });
  }
  void leave_open(unsigned lanes, const std::int32_t* places) {
    for_each_bit(lanes, [&](int i) { open_[open_count_++] = places[i]; });
  }

  /// Writes what the crossing settles of `lanes`; returns what it does not.
  template <Axes axes>
  unsigned unsettled(const Clipped<kind, axes>& c, unsigned lanes, const std::int32_t* places,
                     const Crossing<DoubleLanes>& crossing) {
    const auto s = settled(crossing, c.time, is_exact_);
    const unsigned free = lanes & bits(s.is_free), touches = lanes & ~free & bits(s.touches);
    const unsigned late = touches & bits(s.lower > DoubleLanes(list_.options.latest));
    keep_free(free | late, places);
    const DoubleLanes fields[] = {s.lower, s.upper, s.u, s.v, s.normal.x, s.normal.y, s.normal.z};
    double f[7][kDoubleLanes];
    for (int k = 0; k < 7; ++k) fields[k].store_unaligned(f[k]);
    for_each_bit(touches & ~late, [&](int i) {
      results_[places[i]] = {true,    Certainty::certified,       f[0][i], f[1][i], f[2][i],
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
  const bool is_exact_ = list_.options.guarantee == Guarantee::exact;
};

}  // namespace

int settle_vf(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
              std::int32_t* open) {
  return Settling<PairKind::vertex_face>(list, rest, results, open).run(in);
}
int settle_ee(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
              std::int32_t* open) {
  return Settling<PairKind::edge_edge>(list, rest, results, open).run(in);
}
int settle_ve(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
              std::int32_t* open) {
  return Settling<PairKind::vertex_edge>(list, rest, results, open).run(in);
}
int settle_vv(const ListedPairs& list, const PairBuffer& in, PairBuffer& rest, PairResult* results,
              std::int32_t* open) {
  return Settling<PairKind::vertex_vertex>(list, rest, results, open).run(in);
}

}  // namespace tamis::TAMIS_ISA
