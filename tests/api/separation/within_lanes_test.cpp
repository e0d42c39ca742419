// Runs the families of single pairs through a whole detector with a separation: many pairs in one place, and a filter
// that lets each feature meet its own partner only. Lanes must give the same bits as the functions for one pair, which
// tests/pair/narrow compares with the oracle. Would catch: a lane that computes otherwise than the function for one
// pair, a lane that takes a neighbour's data when pairs are compacted, a pair that is lost between two probes.
#include <gtest/gtest.h>

#include <map>

#include "pair/motion/pair_kinds.hpp"
#include "scenes/scene_list.hpp"
#include "support/ask_pair.hpp"
#include "support/contact_sets.hpp"
#include "support/kernels_here.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"
#include "support/test_names.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

constexpr Index kPairsOfAKind = 48;

/// Pair i has the vertices 4 i, 4 i + 1, ...
struct PairsWithin {
  PairKind kind;
  scenes::Scene scene;
  std::vector<oracle::Motion> motions;

  PairsWithin(PairKind k, const Family& family, const Placement& placement, Random& random) : kind(k) {
    for (Index i = 0; i < kPairsOfAKind; ++i) {
      motions.push_back(permuted(kind, placed(family.make(kind, random), placement), random));
      for (std::size_t v = 0; v < 4; ++v) scene.add_vertex(motions.back().start[v], motions.back().end[v], i);
      add_features(4 * i);
    }
  }
  std::array<Index, 4> vertices(Index i) const {
    std::array<Index, 4> result{-1, -1, -1, -1};
    for (std::size_t v = 0; v < vertex_count(kind); ++v) result[v] = 4 * i + static_cast<Index>(v);
    return result;
  }

 private:
  void add_features(Index v) {
    if (kind != PairKind::edge_edge) scene.loose_points.push_back(v);
    if (kind == PairKind::vertex_face) scene.faces.push_back({v + 1, v + 2, v + 3});
    if (kind == PairKind::vertex_edge) scene.loose_edges.push_back({v + 1, v + 2});
    if (kind == PairKind::vertex_vertex) scene.loose_points.push_back(v + 1);
    if (kind != PairKind::edge_edge) return;
    scene.loose_edges.push_back({v, v + 1});
    scene.loose_edges.push_back({v + 2, v + 3});
  }
};

Options options_within(const PairsWithin& pairs, Isa isa, double separation) {
  Options options;
  options.isa = isa;
  options.min_separation = separation;
  options.filter.accepts = [kind = pairs.kind](PairKind k, const std::array<Index, 4>& v) {
    const std::size_t last = vertex_count(kind) - 1;
    return k == kind && v[0] / 4 == v[1] / 4 && v[0] / 4 == v[last] / 4;
  };
  return options;
}

bool are_same(const Contact& c, const PairResult& r) {
  return c.certainty == r.certainty && c.toi_lower == r.toi_lower && c.toi_upper == r.toi_upper && c.u == r.u &&
         c.v == r.v && c.normal == r.normal;
}

class WithinLanes : public testing::TestWithParam<Isa> {
 protected:
  static void check(const PairsWithin& pairs, const Options& options) {
    std::map<Index, Contact> found;
    for (const Contact& c : find_contacts(pairs.scene, options)) found.emplace(c.vertices[0] / 4, c);
    for (Index i = 0; i < kPairsOfAKind; ++i) {
      const oracle::Motion& m = pairs.motions[static_cast<std::size_t>(i)];
      SCOPED_TRACE(describe(pairs.kind, m) + "\n  separation " + std::to_string(options.min_separation));
      const PairResult alone = ask_pair(pairs.kind, m, {options.min_separation});
      ASSERT_EQ(found.contains(i), alone.touches);
      if (!alone.touches) continue;
      EXPECT_EQ(found[i].vertices, pairs.vertices(i));
      EXPECT_TRUE(are_same(found[i], alone)) << found[i].toi_lower << " to " << found[i].toi_upper << ", alone "
                                             << alone.toi_lower << " to " << alone.toi_upper;
    }
  }
};

TEST_P(WithinLanes, SayBitForBitWhatTheFunctionsForOnePairSay) {
  const long meshes = repetitions("TAMIS_LANE_MESHES", 1);
  Random random(47);
  try {
    for (const Family& family : kFamilies)
      for (const Placement& placement : kPlacements)
        for (const PairKind kind : kAllKinds)
          for (long i = 0; i < meshes && !HasFailure(); ++i) {
            SCOPED_TRACE(std::string(family.name) + " " + std::string(placement.name));
            const PairsWithin pairs(kind, family, placement, random);
            const double separation = placement.scale * std::ldexp(1 + random.unit(), -1 - random.below(18));
            check(pairs, options_within(pairs, GetParam(), separation));
          }
  } catch (const InvalidOptions& without_isa) {
    GTEST_SKIP() << without_isa.what();
  }
}

// Would catch: lanes that leave most pairs to be decided one by one, with the same answers but ten times slower.
TEST_P(WithinLanes, DecideNearlyAllPairsOfACloth) {
  const scenes::Scene scene = scenes::scene_by_name("folded-cloth", 3000, 3);
  for (const double separation : {1e-6, 1e-3, 1e-2}) try {
      Options options;
      options.min_separation = separation;
      options.isa = GetParam();
      Detector detector(scene.mesh(), options);
      const std::size_t contacts = detector.contacts(scene.step()).size();
      const Statistics& statistics = detector.statistics();
      const PrecisionCount& by = statistics.decided_by;
      EXPECT_GT(contacts, 100u);
      EXPECT_GE(by.lanes, contacts - contacts / 100) << separation;
      EXPECT_LE(by.scalar + by.exact, by.lanes / 100) << separation;
      // The separation axes cull nearly all free pairs.
      EXPECT_LE(statistics.stages.back().vf + statistics.stages.back().ee, 2 * contacts) << separation;
    } catch (const InvalidOptions& without_isa) {
      GTEST_SKIP() << without_isa.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Isas, WithinLanes, testing::ValuesIn(every_isa()),
                         [](const testing::TestParamInfo<Isa>& isa) { return test_name(name_of(isa.param)); });

}  // namespace
}  // namespace tamis::test
