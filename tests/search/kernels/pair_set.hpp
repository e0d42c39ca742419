// Pairs of one kind, as motions for the oracle, and as buffers and packed vertices for the kernels.
#pragma once
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "search/bounds/packed_motion.hpp"
#include "search/kernels/kernels.hpp"
#include "support/pair_cases.hpp"

namespace tamis::test {

/// Pairs with vertices of their own: pair i has the vertices from 4 i on.
struct PairSet {
  PairSet(PairKind k, std::vector<oracle::Motion> m, double separation, bool has_radii = false)
      : kind(k), motions(std::move(m)) {
    Random random(17);
    for (const oracle::Motion& motion : motions) {
      start.insert(start.end(), motion.start.begin(), motion.start.end());
      end.insert(end.end(), motion.end.begin(), motion.end.end());
      const float first = random.coin() ? 0.0f : static_cast<float>(random.below(9)) / 16;
      times.push_back({first, random.coin() ? 1.0f : first + static_cast<float>(random.below(8)) / 16});
    }
    used.resize(start.size());
    std::iota(used.begin(), used.end(), 0);
    if (has_radii)
      for (std::size_t i = 0; i < used.size(); ++i) radii.push_back(random.below(3) * 0x1p-5);
    packed.assign({start, end}, used, {separation, radii});
  }

  PairSet(PairSet&&) = default;  // no copies: `packed` refers to the radii

  int size() const { return static_cast<int>(motions.size()); }
  bool touches_at(int i, const oracle::Times& when) const {
    const Index v = 4 * i;
    const double separation = packed.separations.between(kind, {v, v + 1, v + 2, v + 3});
    return oracle::comes_within(kind, motions[static_cast<std::size_t>(i)], separation, when);
  }
  /// A buffer with pairs first, first + 1, ..., again and again. The padding goes on with them.
  std::unique_ptr<PairBuffer> buffer(int first, int count, bool whole_step) const {
    auto pairs = std::make_unique<PairBuffer>();
    for (int i = 0; i < PairBuffer::kSize; ++i) {
      const int pair = (first + i) % size();
      for (int corner = 0; corner < 4; ++corner) pairs->corner[corner][i] = 4 * pair + corner;
      const auto [from, to] = whole_step ? std::pair(0.0f, 1.0f) : times[static_cast<std::size_t>(pair)];
      pairs->t_in[i] = from, pairs->t_out[i] = to;
    }
    pairs->count = count;
    return pairs;
  }

  PairKind kind;
  std::vector<oracle::Motion> motions;
  std::vector<Point> start, end;
  std::vector<std::pair<float, float>> times;
  std::vector<Index> used;
  std::vector<double> radii;
  PackedMotion packed;
};

}  // namespace tamis::test
