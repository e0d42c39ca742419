// All kernels of one instruction set: this file is compiled once for each.
#include <cstring>

#include "filters/dnf.hpp"
#include "filters/ncf.hpp"
#include "kernels/load_motion.hpp"
#include "kernels/search.hpp"
#include "solve/crossing.hpp"

namespace tamis::TAMIS_ISA {
namespace {

template <PairKind kind>
void search(Search& state, int block) {
  BlockSearch<kind>(state, block).run();
}

TimeInterval<DoubleLanes> load_time(const PairBuffer& pairs, int first) {
  return {DoubleLanes::load_unaligned(pairs.t_in + first), DoubleLanes::load_unaligned(pairs.t_out + first)};
}

void copy_pair(const PairBuffer& in, int from, PairBuffer& out) {
  for (int c = 0; c < 4; ++c) out.corner[c][out.count] = in.corner[c][from];
  out.t_in[out.count] = in.t_in[from];
  out.t_out[out.count] = in.t_out[from];
  ++out.count;
}

/// In floats: the times need not be sharp here, and twice as many pairs fit.
template <PairKind kind>
void slab(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& out) {
  for (int first = 0; first < in.count; first += kFloatLanes) {
    const auto low = load_time(in, first), high = load_time(in, first + kDoubleLanes);
    const auto time = SlabClip::clip_diagonals<kind>(
        load_motion_as_float<kind>(vertices, in, first),
        TimeInterval<FloatLanes>{to_float(low.t_in, high.t_in), to_float(low.t_out, high.t_out)});
    float t_in[kFloatLanes], t_out[kFloatLanes];
    time.t_in.store_unaligned(t_in);
    time.t_out.store_unaligned(t_out);
    for_each_bit(bits(time.t_in <= time.t_out) & lanes_in_use(in, first, kFloatLanes), [&](int lane) {
      copy_pair(in, first + lane, out);
      out.t_in[out.count - 1] = static_cast<double>(t_in[lane]);
      out.t_out[out.count - 1] = static_cast<double>(t_out[lane]);
    });
  }
}

template <PairKind kind>
int filter(const PackedVertex* vertices, const PairBuffer& in, PairBuffer& out) {
  int ncf_count = 0;
  for (int first = 0; first < in.count; first += kDoubleLanes) {
    const auto time = load_time(in, first);
    const auto m = restrict_to(load_motion<kind>(vertices, in, first), time.t_in, time.t_out);
    unsigned left = lanes_in_use(in, first) & ~bits(Dnf::proves_free<kind>(m));
    if (!left) continue;
    ncf_count += __builtin_popcount(left);
    left &= ~bits(Ncf::proves_free<kind>(m));
    for_each_bit(left, [&](int lane) { copy_pair(in, first + lane, out); });
  }
  return ncf_count;
}

/// Outward rounding of t_in + s (t_out - t_in), s in [0,1], to the step's time.
DoubleLanes to_step(const TimeInterval<DoubleLanes>& time, const DoubleLanes& s, double direction) {
  const DoubleLanes t = (DoubleLanes(1) - s) * time.t_in + s * time.t_out;
  return min(max(t + DoubleLanes(direction * 4 * error_bounds::unit_roundoff<double>) * time.t_out, time.t_in),
             time.t_out);
}

/// One array a field, one entry a lane.
struct SolvedLanes {
  enum Field { kLower, kUpper, kU, kV, kNormalX, kNormalY, kNormalZ, kFieldCount };
  double field[kFieldCount][kDoubleLanes];

  SolvedLanes(const Crossing<DoubleLanes>& c, const TimeInterval<DoubleLanes>& time) {
    const DoubleLanes length = sqrt(dot(c.normal, c.normal)), zero(0), one(1);
    to_step(time, c.lower, -1).store_unaligned(field[kLower]);
    to_step(time, c.upper, 1).store_unaligned(field[kUpper]);
    min(max(c.u, zero), one).store_unaligned(field[kU]);
    min(max(c.v, zero), one).store_unaligned(field[kV]);
    (c.normal.x / length).store_unaligned(field[kNormalX]);
    (c.normal.y / length).store_unaligned(field[kNormalY]);
    (c.normal.z / length).store_unaligned(field[kNormalZ]);
  }
};

template <PairKind kind>
int solve(const PackedVertex* vertices, const PairBuffer& in, SolvedPair* out) {
  int count = 0;
  for (int first = 0; first < in.count; first += kDoubleLanes) {
    const auto time = load_time(in, first);
    const auto c = find_crossing<kind>(restrict_to(load_motion<kind>(vertices, in, first), time.t_in, time.t_out));
    const unsigned left = lanes_in_use(in, first) & ~bits(c.is_free), touches = bits(c.touches);
    if (!left) continue;
    const SolvedLanes lanes(c, time);
    for_each_bit(left, [&](int i) {
      using L = SolvedLanes;
      const auto& f = lanes.field;
      out[count++] = {first + i,
                      (touches >> i & 1) != 0,
                      f[L::kLower][i],
                      f[L::kUpper][i],
                      f[L::kU][i],
                      f[L::kV][i],
                      {f[L::kNormalX][i], f[L::kNormalY][i], f[L::kNormalZ][i]}};
    });
  }
  return count;
}

}  // namespace

extern const Kernels kKernels;
constexpr auto kVf = PairKind::vertex_face, kEe = PairKind::edge_edge;
const Kernels kKernels{Isa::TAMIS_ISA, search<kVf>, search<kEe>, slab<kVf>, slab<kEe>,
                       filter<kVf>,    filter<kEe>, solve<kVf>,  solve<kEe>};

}  // namespace tamis::TAMIS_ISA
