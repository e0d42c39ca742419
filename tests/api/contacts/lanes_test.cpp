// Runs the families of single pairs through a whole detector: many pairs in one mesh, all in one place, and a filter
// that lets each feature meet its own partner only. So the boxes, the slab clip, the filters and the roots in SIMD
// lanes meet every degeneracy and every rounding trap of the tests of one pair, with unlike neighbours in each block.
// A pair's answer has the same bits as that of the pair alone.
// TAMIS_LANE_MESHES sets the number of meshes for each family, placement and instruction set (long runs).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/contact_sets.hpp"
#include "support/kernels_here.hpp"
#include "support/pair_cases.hpp"
#include "support/test_data.hpp"
#include "support/test_names.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"
#include "tamis/world.hpp"

namespace tamis::test {
namespace {

constexpr Index kPairs = 48;

/// Pair i has the vertices 4 i .. 4 i + 3.
struct PairsInOnePlace {
  PairKind kind;
  scenes::Scene scene;
  std::vector<oracle::Motion> motions;
  PairSet truth;

  PairsInOnePlace(PairKind k, const Family& family, const Placement& placement, Random& random) : kind(k) {
    for (Index i = 0; i < kPairs; ++i) {
      motions.push_back(permuted(kind, placed(family.make(kind, random), placement), random));
      for (std::size_t v = 0; v < 4; ++v) scene.add_vertex(motions.back().start[v], motions.back().end[v], i);
      if (kind == PairKind::vertex_face) {
        scene.loose_points.push_back(4 * i);
        scene.faces.push_back({4 * i + 1, 4 * i + 2, 4 * i + 3});
      } else {
        scene.loose_edges.push_back({4 * i, 4 * i + 1});
        scene.loose_edges.push_back({4 * i + 2, 4 * i + 3});
      }
      if (oracle::touches(kind, motions.back())) truth.insert(name(i));
    }
  }

  PairName name(Index i) const { return {kind, {4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3}}; }
};

Options options_for(PairKind kind, Isa isa) {
  Options options;
  options.isa = isa;
  options.filter.accepts = [kind](PairKind k, const std::array<Index, 4>& v) {
    return k == kind && v[0] / 4 == v[1] / 4 && v[0] / 4 == v[2] / 4 && v[0] / 4 == v[3] / 4;
  };
  return options;
}

/// Time, place and normal.
std::array<double, 7> bits_of(const auto& c) {
  return {c.toi_lower, c.toi_upper, c.u, c.v, c.normal[0], c.normal[1], c.normal[2]};
}

/// The pair's two features, which have no vertex but these four.
scenes::Scene scene_of_pair(const PairsInOnePlace& pairs, const Contact& contact) {
  scenes::Scene alone;
  for (const Index v : contact.vertices)
    alone.add_vertex(pairs.scene.start[static_cast<std::size_t>(v)], pairs.scene.end[static_cast<std::size_t>(v)], 0);
  if (pairs.kind == PairKind::vertex_face) {
    alone.loose_points = {0};
    alone.faces = {{1, 2, 3}};
  } else {
    alone.loose_edges = {{0, 1}, {2, 3}};
  }
  return alone;
}

/// Two bodies in a world.
std::vector<BodyContact> contacts_in_world(PairKind kind, const scenes::Scene& alone, Isa isa) {
  Options options;
  options.isa = isa;
  World world(options);
  const auto add = [&](Mesh mesh, std::ptrdiff_t first, std::ptrdiff_t last) {
    const std::vector<Point> start(alone.start.begin() + first, alone.start.begin() + last);
    const std::vector<Point> end(alone.end.begin() + first, alone.end.begin() + last);
    world.add({std::move(mesh), start}, Deforming{start, end});
  };
  if (kind == PairKind::vertex_face) {
    add(Mesh(1, {}, {}, {0}), 0, 1);
    add(Mesh(3, {{0, 1, 2}}), 1, 4);
  } else {
    add(Mesh(2, {}, {{0, 1}}), 0, 2);
    add(Mesh(2, {}, {{0, 1}}), 2, 4);
  }
  return world.contacts();
}

class Lanes : public testing::TestWithParam<Isa> {
 protected:
  /// Bug: roots were sought in the times that the boxes of the whole mesh left, so that neighbours changed last bits.
  static void expect_bits_of_the_pair_alone(const PairsInOnePlace& pairs, const Contact& contact, Isa isa) {
    const scenes::Scene alone = scene_of_pair(pairs, contact);
    PairOptions options;
    options.isa = isa;
    const std::vector<FeaturePair> listed{{contact.kind, {0, 1, 2, 3}}};
    const std::vector<PairResult> result = narrow_phase(listed, {alone.start, alone.end}, options);
    EXPECT_EQ(bits_of(result.front()), bits_of(contact)) << "in a list";
    const std::vector<Contact> in_mesh = find_contacts(alone, options_for(pairs.kind, isa));
    ASSERT_EQ(in_mesh.size(), 1u);
    EXPECT_EQ(bits_of(in_mesh.front()), bits_of(contact)) << "in a mesh of its own";
    const std::vector<BodyContact> in_world = contacts_in_world(pairs.kind, alone, isa);
    const auto same = std::ranges::find_if(in_world, [&](const BodyContact& c) { return c.kind == contact.kind; });
    ASSERT_NE(same, in_world.end());
    EXPECT_EQ(bits_of(*same), bits_of(contact)) << "in a world";
  }

  static void check(const PairsInOnePlace& pairs, const Options& options) {
    const auto contacts = find_contacts(pairs.scene, options);
    const PairSet found = names_of(contacts);
    for (Index i = 0; i < kPairs; ++i)
      EXPECT_LE(pairs.truth.contains(pairs.name(i)), found.contains(pairs.name(i)))
          << "missed " << describe(pairs.kind, pairs.motions[static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Contact& c = contacts[i];
      const oracle::Motion& m = pairs.motions[static_cast<std::size_t>(c.vertices[0] / 4)];
      SCOPED_TRACE(describe(c.kind, m));
      EXPECT_TRUE(oracle::touches(c.kind, m, {c.toi_lower, c.toi_upper}))
          << "no contact in [" << c.toi_lower << ", " << c.toi_upper << "]";
      EXPECT_FALSE(c.toi_lower > 0 && oracle::touches(c.kind, m, {0, c.toi_lower, true}))
          << "contact before " << c.toi_lower;
      if (i % 4 == 0) expect_bits_of_the_pair_alone(pairs, c, options.isa);
    }
  }
};

TEST_P(Lanes, EveryFamilyAndPlacementMissesNothingAndKeepsItsBrackets) {
  const long meshes = repetitions("TAMIS_LANE_MESHES", 1);
  Random random(43);
  try {
    for (const Family& family : kFamilies)
      for (const Placement& placement : kPlacements)
        for (const PairKind kind : {PairKind::vertex_face, PairKind::edge_edge})
          for (long i = 0; i < meshes && !HasFailure(); ++i) {
            SCOPED_TRACE(std::string(family.name) + " " + std::string(placement.name));
            check(PairsInOnePlace(kind, family, placement, random), options_for(kind, GetParam()));
          }
  } catch (const InvalidOptions& without_isa) {
    GTEST_SKIP() << without_isa.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Isas, Lanes, testing::ValuesIn(every_isa()),
                         [](const testing::TestParamInfo<Isa>& isa) { return test_name(name_of(isa.param)); });

}  // namespace
}  // namespace tamis::test
