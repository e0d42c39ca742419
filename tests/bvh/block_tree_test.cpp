// Groups of the blocks of a tree: what is kept apart as a whole.
#include "bvh/block_tree.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/kernels.hpp"
#include "scenes/scene_list.hpp"
#include "tamis/options.hpp"

namespace tamis::test {
namespace {

class BlockTreeGroups : public testing::Test {
 protected:
  BlockTreeGroups()
      : scene_(scenes::scene_by_name("touching-spheres", 2000, 1)),
        mesh_(scene_.mesh()),
        filter_(PairFilter::no_self_contact(scene_.group_of_vertex)) {
    motion_.assign(scene_.step(), mesh_.points(), {});
    tree_.set_features(mesh_.edges());
    tree_.set_groups(filter_.group_of_vertex, filter_.groups_may_touch, filter_.group_count);
    tree_.build(motion_, 3, kernels(Isa::best).trees);
  }
  Index group_of(int block, int lane) const {
    return scene_.group_of_vertex[static_cast<std::size_t>(tree_.view().corners[block].vertex[0][lane])];
  }

  scenes::Scene scene_;
  Mesh mesh_;
  PairFilter filter_;
  PackedMotion motion_;
  BlockTree tree_;
};

TEST_F(BlockTreeGroups, ABlockHasTheGroupOfAllItHolds) {
  const TreeView view = tree_.view();
  int alone = 0;
  for (int block = 0; block < view.leaf_blocks; ++block) {
    Index group = group_of(block, 0);
    for (int lane = 1; lane < kBlock; ++lane)
      if (group_of(block, lane) != group) group = BlockGroups::kMixed;
    EXPECT_EQ(view.groups.of[0][block], group) << block;
    alone += group != BlockGroups::kMixed;
  }
  EXPECT_GT(2 * alone, view.leaf_blocks) << "bodies that touch in few places";
  EXPECT_EQ(view.groups.of[view.level_count - 1][0], BlockGroups::kMixed) << "the root holds all";
}

TEST_F(BlockTreeGroups, ANodeIsKeptApartOnlyIfAllInItMayNotTouch) {
  const TreeView view = tree_.view();
  int apart = 0;
  for (int block = 0; block < view.leaf_blocks; ++block)
    for (int other = 0; other < view.leaf_blocks; ++other) {
      const Index mine = view.groups.of[0][block], theirs = view.groups.of[0][other];
      const bool expected = mine >= 0 && mine == theirs;
      EXPECT_EQ(are_kept_apart(view, block, view, 0, other), expected);
      EXPECT_LE(are_kept_apart(view, block, view, 1, other / kBlock), expected);
      apart += expected;
    }
  EXPECT_GT(apart, 0);
}

TEST_F(BlockTreeGroups, WithoutGroupsNothingIsKeptApart) {
  tree_.set_groups({}, {}, 1);
  tree_.build(motion_, 3, kernels(Isa::best).trees);
  EXPECT_FALSE(are_kept_apart(tree_.view(), 0, tree_.view(), 0, 0));
}

}  // namespace
}  // namespace tamis::test
