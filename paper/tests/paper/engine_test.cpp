// The published pipeline, and each of its variants, against every pair tested one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <tuple>

#include "paper/detector.hpp"
#include "scenes/scene_list.hpp"
#include "tamis/error.hpp"

namespace tamis::lab {
namespace {

using Key = std::tuple<PairKind, std::array<Index, 4>>;

std::vector<Key> keys(std::span<const Contact> contacts) {
  std::vector<Key> result;
  for (const Contact& c : contacts) result.emplace_back(c.kind, c.vertices);
  return result;
}

/// What one list has more often than the other, in words.
std::string difference(const std::vector<Key>& found, const std::vector<Key>& expected) {
  std::string text;
  const auto tell = [&](const char* what, const std::vector<Key>& from, const std::vector<Key>& without) {
    std::vector<Key> rest;
    std::set_difference(from.begin(), from.end(), without.begin(), without.end(), std::back_inserter(rest));
    for (const auto& [kind, v] : rest) {
      text.append(what).append(kind == PairKind::vertex_face ? " vf" : " ee");
      for (const Index vertex : v) text.append(" ").append(std::to_string(vertex));
      text.append("; ");
    }
  };
  tell("lost", expected, found);
  tell("too much", found, expected);
  return text;
}

std::vector<Key> contacts_of(const scenes::Scene& scene, const Options& options) {
  Detector detector = make_detector(scene.mesh(), options);
  return keys(detector.contacts(scene.step()));
}

Options with(Method method) {
  Options options;
  options.method = method;
  return options;
}

/// The published system, and every way the laboratory lets one change it.
std::vector<PaperOptions> variants() {
  std::vector<PaperOptions> all;
  for (const std::string_view name : method_choices()) {
    Options options;
    choose_method(options, name);
    all.push_back(options.paper);
  }
  for (const char* volume : {"sphere", "aabb", "obb", "16-dop", "18-dop", "26-dop"})
    all.push_back({bounding_volume_from_name(volume), {}});
  for (const std::string_view filter : filter_names()) all.push_back({BoundingVolume::aabb, {std::string(filter)}});
  all.push_back({BoundingVolume::obb, {}, false, false});
  return all;
}

std::string describe(const PaperOptions& options) {
  std::string text = std::string(name_of(options.bounding_volume)) + (options.orphan_sets ? ", orphans" : "") +
                     (options.representative_triangles ? ", own" : "");
  for (const std::string& filter : options.filters) text += ", " + filter;
  return text;
}

TEST(paper_engine, finds_the_contacts_of_brute_force_on_every_kind_of_mesh) {
  for (const scenes::Recipe& recipe : scenes::recipes())
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const scenes::Scene scene = recipe.make(30 + 25 * static_cast<Index>(seed % 4), seed);
      EXPECT_EQ(difference(contacts_of(scene, with(Method::paper)), contacts_of(scene, with(Method::brute))), "")
          << recipe.name << ", seed " << seed;
    }
}

TEST(paper_engine, every_variant_finds_the_same_contacts) {
  for (const scenes::Recipe& recipe : scenes::recipes()) {
    const scenes::Scene scene = recipe.make(70, 11);
    const auto expected = contacts_of(scene, with(Method::brute));
    for (const PaperOptions& variant : variants()) {
      Options options = with(Method::paper);
      options.paper = variant;
      EXPECT_EQ(difference(contacts_of(scene, options), expected), "") << recipe.name << ": " << describe(variant);
    }
  }
}

TEST(paper_engine, finds_what_comes_within_a_minimum_separation) {
  // Boxes that are not blown up would lose pairs that only come near.
  for (const char* name : {"soup", "folded-cloth", "rod", "points-on-cloth", "fans"}) {
    const scenes::Scene scene = scenes::scene_by_name(name, 60, 3);
    Options options = with(Method::paper), brute = with(Method::brute);
    options.min_separation = brute.min_separation = 0.02;
    const auto expected = contacts_of(scene, brute);
    EXPECT_EQ(difference(contacts_of(scene, options), expected), "") << name;
    EXPECT_GT(expected.size(), contacts_of(scene, with(Method::brute)).size()) << name;
  }
}

TEST(paper_engine, leaves_out_what_the_pair_filter_forbids) {
  const scenes::Scene scene = scenes::scene_by_name("colliding-bodies", 150, 2);
  Options options = with(Method::paper);
  options.filter = PairFilter::no_self_contact(scene.group_of_vertex);
  options.filter.accepts = [](PairKind kind, const std::array<Index, 4>& v) {
    return kind == PairKind::vertex_face || v[0] % 2 == 0;
  };
  Options brute = options;
  brute.method = Method::brute;
  EXPECT_EQ(difference(contacts_of(scene, options), contacts_of(scene, brute)), "");
}

TEST(paper_engine, agrees_with_brute_force_on_the_first_contact_radii_and_pairs_that_touch_at_the_start) {
  for (const scenes::Recipe& recipe : scenes::recipes()) {
    const scenes::Scene scene = recipe.make(60, 12);
    Options paper = with(Method::paper), brute = with(Method::brute);
    Detector a = make_detector(scene.mesh(), paper), b = make_detector(scene.mesh(), brute);
    const QueryOptions ignore{.at_start = AtStart::ignore};
    // Its solver has brackets of its own: both are proven, so they overlap.
    const EarliestContact first = a.earliest(scene.step()), truth = b.earliest(scene.step());
    EXPECT_LE(first.toi_lower, truth.toi_upper) << recipe.name;
    EXPECT_LE(truth.toi_lower, first.toi_upper) << recipe.name;
    EXPECT_EQ(a.is_free(scene.step()), b.is_free(scene.step())) << recipe.name;
    EXPECT_EQ(difference(keys(a.contacts(scene.step(), ignore)), keys(b.contacts(scene.step(), ignore))), "")
        << recipe.name;
    paper.radii = brute.radii = {0.001};
    EXPECT_EQ(difference(contacts_of(scene, paper), contacts_of(scene, brute)), "") << recipe.name;
  }
}

TEST(paper_engine, refuses_what_no_enumeration_names) {
  const Mesh mesh(3, {{0, 1, 2}});
  const auto refuses = [&](auto change) {
    Options bad = with(Method::paper);
    change(bad);
    EXPECT_THROW(make_detector(mesh, bad), InvalidOptions);
  };
  refuses([](Options& bad) { bad.method = static_cast<Method>(3); });
  refuses([](Options& bad) { bad.paper.bounding_volume = static_cast<BoundingVolume>(77); });
  refuses([](Options& bad) { bad.paper.high_level = static_cast<HighLevelCulling>(5); });
  EXPECT_THROW(method_from_name("fast"), InvalidOptions);
  for (const Method method : {Method::tamis, Method::paper, Method::brute})
    EXPECT_EQ(method_from_name(name_of(method)), method);
}

// Bug: cancellation is heard only between questions.
TEST(paper_engine, stops_when_cancelled) {
  const scenes::Scene scene = scenes::scene_by_name("soup", 400, 3);
  Options options = with(Method::paper);
  int asked = 0;
  options.is_cancelled = [&] { return ++asked > 3; };
  EXPECT_THROW(contacts_of(scene, options), Cancelled);
}

TEST(paper_engine, answers_every_question_the_same_way_for_any_number_of_threads) {
  const scenes::Scene scene = scenes::scene_by_name("soup", 2000, 3);
  Options one = with(Method::paper), two = one;
  one.threads = 1;
  two.threads = 2;
  Detector a = make_detector(scene.mesh(), one), b = make_detector(scene.mesh(), two);
  const std::span<const Contact> contacts = a.contacts(scene.step());
  EXPECT_FALSE(contacts.empty());
  EXPECT_EQ(keys(contacts), keys(b.contacts(scene.step())));
  EXPECT_EQ(a.earliest(scene.step()).toi_lower, b.earliest(scene.step()).toi_lower);
  EXPECT_EQ(a.is_free(scene.step()), contacts.empty());
  EXPECT_FALSE(b.is_free(scene.step()));
  // A step that does not move is free; the hierarchy is refitted to it.
  const Step still{scene.start, scene.start};
  EXPECT_TRUE(b.contacts(still).empty());
  EXPECT_TRUE(b.is_free(still));
  EXPECT_EQ(b.earliest(still).toi_lower, 1);
}

TEST(paper_engine, counts_only_what_the_stage_before_leaves) {
  const scenes::Scene scene = scenes::scene_by_name("folded-cloth", 2000, 3);
  TriangleCounts counts;
  Detector detector = make_detector(scene.mesh(), with(Method::paper), &counts);
  (void)detector.contacts(scene.step());
  const auto& stages = detector.statistics().stages;
  ASSERT_EQ(stages.size(), 5U);
  EXPECT_EQ(stages.front().name, "boxes");
  for (std::size_t i = 1; i < stages.size(); ++i) {
    EXPECT_LE(stages[i].vf, stages[i - 1].vf) << stages[i].name;
    EXPECT_LE(stages[i].ee, stages[i - 1].ee) << stages[i].name;
  }
  EXPECT_GT(counts.pairs, 0U);
}

}  // namespace
}  // namespace tamis::lab
