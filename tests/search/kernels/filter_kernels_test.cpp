// The kernels that cull or decide pairs, on every instruction set. The oracle says which pairs they may cull.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "pair/motion/pair_kinds.hpp"
#include "search/kernels/pair_set.hpp"
#include "support/ask_pair.hpp"
#include "support/kernels_here.hpp"

namespace tamis::test {
namespace {

using oracle::Motion;

/// A pair that a kernel leaves, by its number, and the times when it may touch.
using Left = std::tuple<int, float, float>;
/// A pair that lanes decide: its number, then a time, a place and a normal. Undecided pairs have nothing but a number.
using Decided = std::pair<int, std::vector<double>>;

struct Culling {
  std::string name;
  bool takes_separations, whole_step;
  void (*run)(const PairKernels&, const MotionView&, PairBuffer& in, PairBuffer& out);
};
const Culling kSlab{"slab", true, true,
                    [](const PairKernels& kernels, const MotionView& motion, PairBuffer& in, PairBuffer& out) {
                      kernels.slab(motion, in, out);
                    }};
const Culling kFilter{"filter", false, false,
                      [](const PairKernels& kernels, const MotionView& motion, PairBuffer& in, PairBuffer& out) {
                        const int of_ncf = kernels.filter(motion, in, out);
                        EXPECT_TRUE(out.count <= of_ncf && of_ncf <= in.count);
                      }};
const Culling kCullApart{"cull_apart", true, false,
                         [](const PairKernels& kernels, const MotionView& motion, PairBuffer& in, PairBuffer& out) {
                           kernels.cull_apart(motion, in, out);
                         }};

/// What a kernel that culls leaves of pairs first, first + 1, ...
std::vector<Left> left_by(const Culling& culling, const Kernels& kernels, const PairSet& set, int first, int count) {
  const auto in = set.buffer(first, count, culling.whole_step), out = std::make_unique<PairBuffer>();
  culling.run(kernels.of(set.kind), set.packed.view(), *in, *out);
  std::vector<Left> left;
  for (int i = 0; i < out->count; ++i) {
    left.emplace_back(out->corner[0][i] / 4, out->t_in[i], out->t_out[i]);
    for (int corner = 0; corner < 4; ++corner) EXPECT_EQ(out->corner[corner][i], out->corner[0][i] + corner);
  }
  return left;
}

/// The decisions on pairs first, first + 1, ..., by their places in the buffer. Pairs that are free are not there.
std::vector<Decided> decided(const Kernels& kernels, const PairSet& set, double latest, int first, int count) {
  const auto in = set.buffer(first, count, true);
  const auto scratch = std::make_unique<DecisionScratch>();
  const auto room = std::make_unique<DecisionRoom<PairBuffer::kCapacity>>();
  LaneDecisions lists = room->lists();
  kernels.of(set.kind).decide(set.packed.view(), latest, *in, *scratch, lists);
  std::vector<Decided> all;
  for (int i = 0; i < lists.undecided_count; ++i) all.push_back({lists.undecided[i], {}});
  for (int i = 0; i < lists.touching_count; ++i) {
    const auto& [pair, r] = lists.touching[i];
    all.push_back({pair, {r.toi_lower, r.toi_upper, r.u, r.v, r.normal[0], r.normal[1], r.normal[2]}});
  }
  std::sort(all.begin(), all.end());
  return all;
}

class FilterKernels : public testing::TestWithParam<PairKind> {
 protected:
  /// Some pairs of each family; their number is no multiple of the lanes. With no, small, large and mixed separations.
  static std::vector<PairSet> sets(bool with_separations) {
    Random random(5);
    std::vector<Motion> motions;
    for (const Family& family : kFamilies)
      for (int i = 0; i < 5; ++i) motions.push_back(family.make(GetParam(), random));
    motions.push_back(family_named("separated").make(GetParam(), random));
    std::vector<PairSet> sets;
    sets.emplace_back(GetParam(), motions, 0);
    if (!with_separations) return sets;
    for (const double separation : {0x1p-20, 0.25}) sets.emplace_back(GetParam(), motions, separation);
    sets.emplace_back(GetParam(), motions, 0x1p-6, true);
    return sets;
  }
  static std::vector<Culling> cullings() {
    if (can_cross(GetParam())) return {kSlab, kFilter, kCullApart};
    return {kSlab, kCullApart};
  }
  /// f(kernels) for each instruction set of this machine.
  template <class F>
  static void for_each_isa(const F& f) {
    for (const Isa isa : every_isa())
      if (const Kernels* kernels = kernels_here(isa)) {
        SCOPED_TRACE(name_of(isa));
        f(*kernels);
      }
  }
};

/// `left`: what a kernel leaves of all pairs of the set.
void expect_that_culled_is_free(const PairSet& set, const PairBuffer& in, std::vector<Left> left) {
  left.emplace_back(set.size(), 0.0f, 0.0f);
  auto next = left.begin();
  for (int i = 0; i < set.size(); ++i) {
    SCOPED_TRACE(describe(set.kind, set.motions[static_cast<std::size_t>(i)]));
    const double from = in.t_in[i], to = in.t_out[i];
    if (std::get<int>(*next) != i) {
      EXPECT_FALSE(set.touches_at(i, {from, to}));
      continue;
    }
    const auto [pair, t_in, t_out] = *next++;
    EXPECT_TRUE(from <= t_in && t_in <= t_out && t_out <= to);
    EXPECT_FALSE(t_in > from && set.touches_at(i, {from, t_in, true}));
    EXPECT_FALSE(t_out < to && set.touches_at(i, {std::nextafter(double{t_out}, 2.0), to}));
  }
  EXPECT_EQ(std::get<int>(*next), set.size()) << "a pair that is not in the buffer";
}

// Bugs: a certificate that is not strict, a margin too small for floats, a time cut short, radii left out.
TEST_P(FilterKernels, CullNoPairAndNoTimeThatTouchesByTheOracle) {
  for (const Culling& culling : cullings())
    for (const PairSet& set : sets(culling.takes_separations))
      for_each_isa([&](const Kernels& kernels) {
        SCOPED_TRACE(culling.name + ", separation " + std::to_string(set.packed.separations.fixed));
        const auto in = set.buffer(0, set.size(), culling.whole_step);
        expect_that_culled_is_free(set, *in, left_by(culling, kernels, set, 0, set.size()));
      });
}

void expect_decided_as_by_oracle(const PairSet& set, double latest, std::vector<Decided> all) {
  all.push_back({set.size(), {}});
  auto next = all.begin();
  for (int i = 0; i < set.size(); ++i) {
    SCOPED_TRACE(describe(set.kind, set.motions[static_cast<std::size_t>(i)]));
    if (next->first != i) {
      EXPECT_FALSE(set.touches_at(i, {0, latest}));
    } else if (const auto& values = (next++)->second; !values.empty()) {
      EXPECT_LE(values[0], latest);
      EXPECT_TRUE(set.touches_at(i, {values[0], values[1]}));
      EXPECT_FALSE(values[0] > 0 && set.touches_at(i, {0, values[0], true}));
    }
  }
  EXPECT_EQ(next->first, set.size()) << "a pair is there twice";
}

// Bugs: a pair lost between two lists, a time bracket without the first contact, a limit that cuts too early.
TEST_P(FilterKernels, DecideAsTheOracleDoes) {
  for (const PairSet& set : sets(true))
    for (const double latest : {1.0, 0.5})
      for_each_isa([&](const Kernels& kernels) {
        const auto all = decided(kernels, set, latest, 0, set.size());
        EXPECT_GT(all.size(), 5u);
        expect_decided_as_by_oracle(set, latest, all);
      });
}

// Bugs: a fused or approximate operation of one instruction set, a compressed store in another order.
TEST_P(FilterKernels, AnswerAlikeOnAllInstructionSets) {
  const Kernels& best = kernels(Isa::best);
  for (const PairSet& set : sets(true))
    for_each_isa([&](const Kernels& kernels) {
      for (const Culling& culling : cullings())
        EXPECT_EQ(left_by(culling, kernels, set, 0, set.size()), left_by(culling, best, set, 0, set.size()));
      EXPECT_EQ(decided(kernels, set, 1, 0, set.size()), decided(best, set, 1, 0, set.size()));
    });
}

// Bugs: lanes behind the last pair that count, a last pair that does not, an answer that depends on other lanes.
TEST_P(FilterKernels, AnswerInBuffersOfAnySizeAsAboutEachPairAlone) {
  const std::vector<PairSet> sets = FilterKernels::sets(false);
  const PairSet& set = sets.front();
  const auto place = [&](int i) { return static_cast<std::size_t>(i % set.size()); };
  for_each_isa([&](const Kernels& kernels) {
    std::vector<std::vector<Decided>> decided_alone;
    for (int i = 0; i < set.size(); ++i) decided_alone.push_back(decided(kernels, set, 1, i, 1));
    for (const int count : {0, 1, 3, 15, 16, 17, PairBuffer::kCapacity - 1, PairBuffer::kCapacity}) {
      std::vector<Decided> expected;
      for (int i = 0; i < count; ++i)
        for (const Decided& one : decided_alone[place(i)]) expected.emplace_back(i, one.second);
      EXPECT_EQ(decided(kernels, set, 1, 0, count), expected) << count;
    }
    for (const Culling& culling : cullings()) {
      std::vector<std::vector<Left>> left_alone;
      for (int i = 0; i < set.size(); ++i) left_alone.push_back(left_by(culling, kernels, set, i, 1));
      for (const int count : {0, 1, 3, 15, 16, 17, PairBuffer::kCapacity - 1, PairBuffer::kCapacity}) {
        std::vector<Left> expected;
        for (int i = 0; i < count; ++i)
          expected.insert(expected.end(), left_alone[place(i)].begin(), left_alone[place(i)].end());
        EXPECT_EQ(left_by(culling, kernels, set, 0, count), expected) << culling.name << ", " << count;
      }
    }
  });
}

// Bug: a kernel that keeps everything, which no test above would see.
TEST_P(FilterKernels, CullAPairThatStaysFarApart) {
  const Point a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, above{0.25, 0.25, 1}, below{0.25, 0.25, -1};
  Motion through{{{above, a, b, c}}, {{below, a, b, c}}}, apart{{{above, a, b, c}}, {{{0.25, 0.25, 0.5}, a, b, c}}};
  if (GetParam() == PairKind::edge_edge) {
    const Point other{1, 0.5, 1};
    through = {{{a, {1, 1, 0}, above, other}}, {{a, {1, 1, 0}, below, {1, 0.5, -1}}}};
    apart = {{{a, {1, 1, 0}, above, other}}, {{a, {1, 1, 0}, {0.25, 0.25, 0.5}, {1, 0.5, 0.5}}}};
  } else if (GetParam() != PairKind::vertex_face) {
    through = {{{above, above, b, c}}, {{below, above, b, c}}};
  }
  PairSet set{GetParam(), {through, apart}, 0};
  for (auto& times : set.times) times = {0, 1};
  for_each_isa([&](const Kernels& kernels) {
    for (const Culling& culling : cullings()) {
      const auto left = left_by(culling, kernels, set, 0, set.size());
      EXPECT_TRUE(left.size() == 1 && std::get<int>(left[0]) == 0) << culling.name;
    }
    const auto left = decided(kernels, set, 1, 0, set.size());
    EXPECT_TRUE(left.size() == 1 && left[0].first == 0);
  });
}

INSTANTIATE_TEST_SUITE_P(Kinds, FilterKernels, testing::ValuesIn(kAllKinds),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

}  // namespace
}  // namespace tamis::test
