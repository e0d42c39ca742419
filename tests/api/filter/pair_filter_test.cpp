// Pair filters: in every method, the contacts are those of the unfiltered step that the filter lets pass.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <vector>

#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/flat_sheets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

/// Contacts of the scene for which `keeps(group of the first feature, group of the second, name)` is true.
template <class Keeps>
PairSet kept(const Scene& scene, const PairSet& all, const Keeps& keeps) {
  PairSet result;
  for (const PairName& name : all) {
    const auto group = [&](std::size_t i) { return scene.group_of_vertex[static_cast<std::size_t>(name.vertices[i])]; };
    if (keeps(group(0), group(name.kind == PairKind::vertex_face ? 1 : 2), name)) result.insert(name);
  }
  return result;
}

class PairFilters : public testing::TestWithParam<Method> {
 protected:
  PairSet find(const Scene& scene, const PairFilter& filter) const {
    yardstick::Options options;
    options.method = GetParam();
    options.filter = filter;
    return find_names(scene, options);
  }
  /// A few scenes of several objects each.
  static std::vector<Scene> scenes_of_objects() {
    return {scenes::scene_by_name("static", 60, 1), scenes::scene_by_name("sliding-sheets", 60, 2),
            scenes::scene_by_name("touching-spheres", 200, 3), scenes::scene_by_name("rod", 40, 4)};
  }
};

TEST_P(PairFilters, NoSelfContactLeavesOutPairsWithinOneObject) {
  for (const Scene& scene : scenes_of_objects()) {
    const PairSet expected = kept(scene, find(scene, {}), [](Index a, Index b, const PairName&) { return a != b; });
    EXPECT_EQ(find(scene, PairFilter::no_self_contact(scene.group_of_vertex)), expected) << scene.name;
  }
}

TEST_P(PairFilters, NoStaticPairsKeepsPairsWithAMovingObject) {
  for (const Scene& scene : scenes_of_objects()) {
    const Index groups = 1 + *std::max_element(scene.group_of_vertex.begin(), scene.group_of_vertex.end());
    std::vector<bool> is_static(static_cast<std::size_t>(groups));
    for (std::size_t g = 0; g < is_static.size(); ++g) is_static[g] = g % 2 == 0;
    const PairSet expected = kept(scene, find(scene, {}), [&](Index a, Index b, const PairName&) {
      return !is_static[static_cast<std::size_t>(a)] || !is_static[static_cast<std::size_t>(b)];
    });
    EXPECT_EQ(find(scene, PairFilter::no_static_pairs(scene.group_of_vertex, is_static)), expected) << scene.name;
  }
}

// Catches a callback that gets vertices in another order than Contact documents.
TEST_P(PairFilters, CallbackDecidesByTheNamesOfTheContacts) {
  for (const Scene& scene : scenes_of_objects()) {
    const auto accepts = [](PairKind kind, const std::array<Index, 4>& v) {
      return (v[0] + 2 * v[1] + 3 * v[2] + 4 * v[3]) % (kind == PairKind::vertex_face ? 3 : 2) == 0;
    };
    const PairSet expected = kept(
        scene, find(scene, {}), [&](Index, Index, const PairName& name) { return accepts(name.kind, name.vertices); });
    PairFilter filter;
    filter.accepts = accepts;
    EXPECT_EQ(find(scene, filter), expected) << scene.name;
  }
}

// Catches an interrupted question that leaves pairs in the buffers: the next answer had them twice.
TEST_P(PairFilters, AQuestionThatACallbackInterruptsLeavesNothingBehind) {
  struct Interrupted {};
  for (const Scene& scene : scenes_of_objects()) {
    std::atomic<int> calls = 0, last_call = std::numeric_limits<int>::max();
    yardstick::Options options;
    options.method = GetParam();
    options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
      if (++calls > last_call) throw Interrupted();
      return true;
    };
    const PairSet expected = names_of(contacts_of(yardstick::make_detector(scene.mesh(), options), scene.step()));
    const int all_calls = calls;
    ASSERT_GT(all_calls, 0) << scene.name;
    for (const int interrupted : {0, all_calls / 2, all_calls - 1}) {
      Detector detector = yardstick::make_detector(scene.mesh(), options);
      calls = 0;
      last_call = interrupted;
      EXPECT_THROW((void)detector.contacts(scene.step()), Interrupted) << scene.name;
      last_call = std::numeric_limits<int>::max();
      std::span<const Contact> again = detector.contacts(scene.step());
      EXPECT_EQ(again.size(), expected.size()) << scene.name << ", interrupted after " << interrupted << " calls";
      EXPECT_EQ(names_of(again), expected);
    }
  }
}

// Catches a question that makes pairs of groups that may not touch, and drops them one by one.
TEST(PairFilterBlocks, WholeBlocksAreLeftOut) {
  const Scene scene = scenes::scene_by_name("touching-spheres", 20000, 1);
  const auto nodes_of = [&](const PairFilter& filter) {
    yardstick::Options options;
    options.filter = filter;
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    std::vector<std::uint64_t> nodes;
    (void)detector.contacts(scene.step());
    nodes.push_back(detector.statistics().nodes_visited);
    (void)detector.safe_step(scene.step(), 0.1);
    nodes.push_back(detector.statistics().nodes_visited);
    (void)detector.pairs_within(scene.step().start, 1e-3);
    nodes.push_back(detector.statistics().nodes_visited);
    return nodes;
  };
  const auto all = nodes_of({}), others = nodes_of(PairFilter::no_self_contact(scene.group_of_vertex));
  for (std::size_t question = 0; question < all.size(); ++question) EXPECT_LT(others[question], all[question]);
}

// Catches a question that tests or lists pairs although their groups leave them out. Each group may touch itself, so
// that blocks are mixed.
TEST(PairFilterBlocks, PairsThatGroupsLeaveOutAreNotLookedAt) {
  const Scene scene = flat_sheets(20, 0.1, -0.1);
  struct Cost {
    std::uint64_t near = 0, listed_bytes = 0;
  };
  const auto cost_of = [&](const PairFilter& of) {
    yardstick::Options options;
    options.filter = of;
    options.threads = 1;  // each thread has its own buffers, which would count as memory
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    (void)detector.safe_step(scene.step(), 0.1);
    Cost cost;
    for (const StageCount& stage : detector.statistics().stages)
      if (stage.name == "near") cost.near = stage.vf + stage.ee;
    (void)detector.contacts(scene.step());
    const std::uint64_t before = detector.statistics().memory_bytes;
    (void)detector.contacts(scene.step());  // the second question lists pairs
    cost.listed_bytes = detector.statistics().memory_bytes - before;
    return cost;
  };
  const Cost all = cost_of({}), others = cost_of({scene.group_of_vertex, 2, {1, 0, 0, 1}});
  EXPECT_GT(all.near, 100u);
  EXPECT_EQ(others.near, 0u);
  EXPECT_LT(others.listed_bytes, all.listed_bytes / 2);
}

INSTANTIATE_TEST_SUITE_P(Methods, PairFilters, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

// Bug: the number of groups overflowed, and the message named a group that nobody had given.
TEST(PairFilter, RefusesAGroupThatCannotBeCounted) {
  try {
    (void)PairFilter::no_self_contact({0, 2147483647});
    FAIL() << "such a group was taken";
  } catch (const InvalidOptions& error) {
    EXPECT_NE(std::string(error.what()).find("in group 2147483647"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tamis::test
