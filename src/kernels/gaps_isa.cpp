// How far apart the features of two leaf blocks are at t=0: compiled once for each instruction set.
#include "kernels/gaps.hpp"
#include "kernels/load_motion.hpp"
#include "kernels/search.hpp"
#include "solve/difference_corners.hpp"
#include "solve/nearly_closest.hpp"

namespace tamis::TAMIS_ISA {
namespace {

/// One box at t=0 in every lane.
struct StartBox {
  StartBox(const BoxBlock& block, int lane) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = FloatLanes(block.low0[axis][lane]);
      high[axis] = FloatLanes(block.high0[axis][lane]);
    }
  }
  FloatLanes low[3], high[3];
};

/// How far some of sixteen boxes at t=0 are from one: the largest gap along an axis.
FloatLanes gaps_to(const StartBox& one, const BoxBlock& boxes, int first) {
  const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
  FloatLanes largest(0.0f);
  for (int axis = 0; axis < 3; ++axis)
    largest = max(largest, max(load(boxes.low0[axis]) - one.high[axis], one.low[axis] - load(boxes.high0[axis])));
  return largest;
}

/// The largest extent, along an axis, of one box and each of some of sixteen together, at t=0.
FloatLanes extents_with(const StartBox& one, const BoxBlock& boxes, int first) {
  const auto load = [&](const float* lanes) { return FloatLanes::load_aligned(lanes + first); };
  FloatLanes largest(0.0f);
  for (int axis = 0; axis < 3; ++axis)
    largest = max(largest, max(load(boxes.high0[axis]) - one.low[axis], one.high[axis] - load(boxes.low0[axis])));
  return largest;
}

/// Bits of the boxes whose gap to one is smaller.
unsigned nearer_than(float gap, const BoxBlock& boxes, const StartBox& one) {
  unsigned result = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes)
    result |= bits(gaps_to(one, boxes, first) < FloatLanes(gap)) << first;
  return result;
}

/// Bits of the lanes of `block` that share a vertex with feature `lane` of `other`; of empty lanes, anything.
template <int corners, int other_corners>
unsigned adjacent_lanes(const CornerBlock& block, const CornerBlock& other, int lane) {
  using Unsigned = xsimd::batch<std::uint32_t, Arch>;
  unsigned result = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    Unsigned differ(~0u);  // 0 where two vertices are one: cheaper than as many masks
    for (int c = 0; c < corners; ++c)
      for (int o = 0; o < other_corners; ++o)
        differ = xsimd::min(differ, xsimd::bitwise_cast<Unsigned>(IntLanes::load_aligned(block.vertex[c] + first) ^
                                                                  IntLanes(other.vertex[o][lane])));
    result |= bits(differ == Unsigned(0u)) << first;
  }
  return result;
}

/// The smallest lower bound, of the pairs' distances at t=0 less the room to decide them, in the unit of `question`;
/// from `most` downwards.
template <PairKind kind>
float smallest_gap(const GapQuestion& question, const PairBuffer& pairs, float most) {
  FloatLanes smallest(most);
  for (int first = 0; first < pairs.count; first += kFloatLanes) {
    const auto m = load_motion_as_float<kind>(question.vertices, pairs, first, {question.unit, false});
    const Vec3<FloatLanes> gap = NearlyClosest::gap<kind>(m.e.at0, m.f.at0, m.d.at0);
    const Vec3<FloatLanes> axis = (FloatLanes(1.0f) / sqrt(dot(gap, gap))) * gap;
    FloatLanes lowest = dot(axis, m.d.at0);
    for (const auto& corner : difference_corners<kind>(m)) lowest = min(lowest, dot(axis, corner.at0));
    const auto room = error_bounds::constant<FloatLanes>(
        error_bounds::kRoomToAdvance + error_bounds::kKeptGap * error_bounds::unit_roundoff<FloatLanes>);
    const FloatLanes left = max(lowest - room * (m.size_d + m.size_e + m.size_f), FloatLanes(0.0f));
    smallest = min(smallest, left / m.separation);
  }
  float lanes[kFloatLanes];
  smallest.store_unaligned(lanes);
  float result = most;
  for (const float lane : lanes) result = lane < result ? lane : result;
  return result;
}

template <PairKind kind>
float gap_of_blocks(const GapQuestion& question, int block, int other, float most, PairBuffer& scratch) {
  constexpr bool kIsSelf = kind == PairKind::edge_edge;
  constexpr int kCornersA = kIsSelf ? 2 : 1, kCornersB = kIsSelf ? 2 : 3;
  const CornerBlock &mine = question.a.corners[block], &theirs = question.b.corners[other];
  const BoxBlock &few = question.a.levels[0][block], &many = question.b.levels[0][other];
  scratch.count = 0;
  // Of features that are far from all of the other block's nothing is near; nor of empty lanes.
  const StartBox their_hull(question.b.levels[1][other / kBlock], other % kBlock);
  for_each_bit(nearer_than(most, few, their_hull), [&](int lane) {
    unsigned near = nearer_than(most, many, {few, lane});
    if (kIsSelf && other == block) near &= ~1u << lane;
    if (near) near &= ~adjacent_lanes<kCornersB, kCornersA>(theirs, mine, lane);
    for_each_bit(near, [&](int i) {
      const int at = scratch.count++;
      for (int c = 0; c < kCornersA; ++c) scratch.corner[c][at] = mine.vertex[c][lane];
      for (int c = 0; c < kCornersB; ++c) scratch.corner[kCornersA + c][at] = theirs.vertex[c][i];
    });
  });
  // Whole batches: the last pair again.
  for (int i = scratch.count; scratch.count > 0 && i % kFloatLanes != 0; ++i)
    for (auto& corner : scratch.corner) corner[i] = corner[scratch.count - 1];
  return smallest_gap<kind>(question, scratch, most);
}

/// Drifts of some leaf blocks, or of one in every lane.
struct DriftLanes {
  FloatLanes low[BoxVertex::kRadius + 1], high[BoxVertex::kRadius + 1];

  explicit DriftLanes(const MovingBox& box) {
    for (int k = 0; k < BoxVertex::kRadius; ++k) {
      low[k] = FloatLanes(box.low[k]);
      high[k] = FloatLanes(box.high[k]);
    }
  }
  DriftLanes(const MovingBox* boxes, const std::int32_t* blocks) {
    const IntLanes lows = IntLanes::load_unaligned(blocks) + IntLanes::load_unaligned(blocks);
    alignas(64) std::int32_t rows[kFloatLanes];
    lows.store_aligned(rows);
    load_columns(&boxes->low, rows, low);
    (lows + IntLanes(1)).store_aligned(rows);
    load_columns(&boxes->low, rows, high);
  }
};
static_assert(sizeof(MovingBox) == 2 * sizeof(MovingBox::low), "read as rows: low, high, low, ...");

/// As RelativeDrift has it, until t.
FloatLanes relative_drift(const DriftLanes& a, const DriftLanes& b, float t) {
  FloatLanes squares[2] = {FloatLanes(0.0f), FloatLanes(0.0f)};
  for (int k = 0; k < BoxVertex::kRadius; ++k) {
    const FloatLanes way = max(a.high[k] - b.low[k], b.high[k] - a.low[k]);
    squares[k / 3] = squares[k / 3] + way * way;
  }
  const FloatLanes start = sqrt(squares[0]);
  return max(start, start + FloatLanes(t) * (sqrt(squares[1]) - start));
}

}  // namespace

unsigned near_hulls(const BoxBlock& hulls, const BoxBlock& of, int lane, float reach, HullGaps& found) {
  const StartBox one(of, lane);
  unsigned near = 0;
  for (int first = 0; first < kBlock; first += kFloatLanes) {
    const FloatLanes gap = gaps_to(one, hulls, first);
    const FloatLanes room =
        FloatLanes(static_cast<float>(error_bounds::kRoomOfBoxes)) * extents_with(one, hulls, first);
    gap.store_unaligned(found.gap + first);
    room.store_unaligned(found.room + first);
    near |= bits(gap - room < FloatLanes(reach)) << first;
  }
  return near;
}

int unproven(const GapScan& scan, std::int32_t* out) {
  constexpr auto kGrown = static_cast<float>(error_bounds::kDriftWithRoom);
  const DriftLanes own(*scan.own);
  int count = 0;
  for (int first = 0; first < scan.count; first += kFloatLanes) {
    const FloatLanes drift = relative_drift(own, DriftLanes(scan.drifts, scan.others + first), scan.t);
    const auto is_apart =
        FloatLanes::load_unaligned(scan.gaps + first) * FloatLanes(scan.scale) > FloatLanes(kGrown) * drift;
    const int left = scan.count - first;
    const unsigned in_use = left < kFloatLanes ? (1u << left) - 1 : (1u << kFloatLanes) - 1;
    const unsigned mask = in_use & ~bits(is_apart);
    store_compressed(mask, IntLanes::load_unaligned(scan.others + first), out + count);
    count += __builtin_popcount(mask);
  }
  return count;
}

float gap_vf(const GapQuestion& question, int block, int other, float most, PairBuffer& scratch) {
  return gap_of_blocks<PairKind::vertex_face>(question, block, other, most, scratch);
}

float gap_ee(const GapQuestion& question, int block, int other, float most, PairBuffer& scratch) {
  return gap_of_blocks<PairKind::edge_edge>(question, block, other, most, scratch);
}

}  // namespace tamis::TAMIS_ISA
