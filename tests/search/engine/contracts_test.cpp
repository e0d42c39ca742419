// What the parts of the search promise each other: buffers, trees and steps that belong together.
#include "support/contracts.hpp"

#include <vector>

#include "api/list_part.hpp"
#include "api/planar_times.hpp"
#include "search/bounds/shared_motion.hpp"
#include "search/coherence/pair_lists.hpp"
#include "search/engine/feature_trees.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/query/contact_collector.hpp"

namespace tamis::test {
namespace {

using Points = std::vector<Point>;

/// Two triangles, one above the other, and their trees.
struct Trees {
  Mesh mesh{6, {{0, 1, 2}, {3, 4, 5}}};
  Points start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, end = start, other = start;
  Step step{start, end}, other_step{start, other};
  Options options;
  Rings rings{mesh, 1};
  FeatureTrees trees{mesh, options, kernels(Isa::best)};
  Statistics statistics;
};

TEST_F(Contracts, TreesBeforeTheirFirstStep) {
  Trees t;
  EXPECT_DEATH(t.trees.refit_for(t.step, {}, nullptr), "is_built");
}

TEST_F(Contracts, TreesOfAnotherMesh) {
  Trees t;
  const Points few(3);
  EXPECT_DEATH(t.trees.refit_or_rebuild({few, few}, {}, nullptr, LooksAt::whole_step, t.statistics), "vertex_count");
}

TEST_F(Contracts, TreesKnowWhoseBoxesTheyHave) {
  Trees t;
  EXPECT_FALSE(t.trees.are_of(t.step));
  t.trees.refit_or_rebuild(t.step, {}, nullptr, LooksAt::whole_step, t.statistics);
  EXPECT_TRUE(t.trees.are_of(t.step));
  t.trees.load_vertices(t.other_step, {}, nullptr, t.statistics);
  EXPECT_TRUE(t.trees.are_of(t.other_step)) << "nothing moved";
  for (Point& p : t.other) p[2] += 1;  // another step in the same memory
  t.trees.load_vertices(t.other_step, {}, nullptr, t.statistics);
  EXPECT_FALSE(t.trees.are_of(t.other_step)) << "the boxes are where they were";
  t.trees.refit_for(t.other_step, {}, nullptr);
  EXPECT_TRUE(t.trees.are_of(t.other_step));
}

TEST_F(Contracts, ResidualsWithoutBoxes) {
  Trees t;
  EXPECT_DEATH(t.trees.refit_residuals({}), "boxes_are_current_");
}

TEST_F(Contracts, SearchesThatCannotEnd) {
  Trees t;
  t.trees.refit_or_rebuild(t.step, {}, nullptr, LooksAt::whole_step, t.statistics);
  PairBuffer pairs;
  Search search{t.trees.edges(), t.trees.faces()};
  const auto kernel = kernels(Isa::best).of(PairKind::vertex_face).search;
  search.pairs = &pairs;
  EXPECT_DEATH(search_block(kernel, search, 0), "search.flush");
  search.flush = [](Search&) {};
  EXPECT_DEATH(search_block(kernel, search, search.a.leaf_blocks), "leaf_blocks");
  search.t_limit = 2;
  EXPECT_DEATH(search_block(kernel, search, 0), "t_limit");
}

TEST_F(Contracts, BuffersWithoutRoom) {
  PairBuffer pairs;
  pairs.count = 2;
  PairList list;
  list.add(pairs);
  pairs.count = PairBuffer::kCapacity - 1;
  EXPECT_DEATH(append(list.part(0), {0, 1}, 1, pairs), "kCapacity");
  pairs.count = 0;
  EXPECT_DEATH(append(list.part(0), {1, 0}, 1, pairs), "when.t_in <= when.t_out");
  EXPECT_DEATH((void)vertices_of(PairKind::vertex_face, pairs, 0), "pairs.count");
}

TEST_F(Contracts, GroupsOfNoFilter) {
  EXPECT_DEATH((void)may_touch({}, 0, 1), "has_groups");
  const std::vector<Index> group_of_vertex{0, 2};
  const std::vector<std::uint8_t> may{1, 1, 1, 1};
  PairFilter filter;
  filter.group_of_vertex = group_of_vertex;
  filter.groups_may_touch = may;
  filter.group_count = 2;
  EXPECT_DEATH((void)may_touch(filter, 0, 1), "group_count");
  EXPECT_DEATH((void)may_touch(filter, 0, 2), "group_of_vertex.size");
}

TEST_F(Contracts, VerticesBeyondTheStep) {
  const Trees t;
  EXPECT_DEATH((void)points_of(t.step, {0, 3, 4, 6}), "count");
}

TEST_F(Contracts, ContactsThatEndBeforeTheyBegin) {
  const Trees t;
  const Query query{t.step, {}, t.options.filter, t.rings, t.options.is_cancelled};
  Bound bound;
  ContactCollector found;
  found.begin(query, bound);
  const PairResult result{.touches = true, .toi_lower = 0.5, .toi_upper = 0.25};
  EXPECT_DEATH(found.add(PairKind::vertex_face, {0, 3, 4, 5}, result), "is_part");
}

TEST_F(Contracts, FewerResultsThanPairs) {
  const Trees t;
  const std::vector<FeaturePair> pairs(2, {PairKind::vertex_face, {0, 3, 4, 5}});
  std::vector<PairResult> results(1);
  EXPECT_DEATH(decide_part_of_list({pairs, t.step, kernels(Isa::best), PairOptions()}, results), "results.size");
}

TEST_F(Contracts, FractionsOfAStepThatIsCut) {
  EXPECT_DEATH(KeptFractions(0), "0 < kept");
  EXPECT_DEATH(KeptFractions(1), "kept < 1");
}

}  // namespace
}  // namespace tamis::test
