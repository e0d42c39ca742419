// The answer of many ranks is that of one process, bit for bit, whoever has what.
#include <gtest/gtest.h>

#include "mpi/parts.hpp"
#include "scenes/scene_list.hpp"
#include "support/test_names.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

bool same_bits(const Contact& a, const Contact& b) {
  return a.kind == b.kind && a.certainty == b.certainty && a.vertices == b.vertices && a.toi_lower == b.toi_lower &&
         a.toi_upper == b.toi_upper && a.u == b.u && a.v == b.v && a.normal == b.normal;
}

void expect_same(const std::vector<Contact>& one, const std::vector<Contact>& many, const std::string& what) {
  ASSERT_EQ(one.size(), many.size()) << what;
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_TRUE(same_bits(one[i], many[i])) << what << ", contact " << i;
}

void expect_same(const EarliestContact& one, const EarliestContact& many, const std::string& what) {
  EXPECT_EQ(one.toi_lower, many.toi_lower) << what;
  EXPECT_EQ(one.toi_upper, many.toi_upper) << what;
  ASSERT_EQ(one.contact.has_value(), many.contact.has_value()) << what;
  if (!one.contact) return;
  EXPECT_TRUE(same_bits(*one.contact, *many.contact)) << what;
}

void expect_same(const SafeStep& one, const SafeStep& many, const std::string& what) {
  EXPECT_EQ(one.lower, many.lower) << what;
  EXPECT_EQ(one.upper, many.upper) << what;
  ASSERT_EQ(one.pair.has_value(), many.pair.has_value()) << what;
  if (!one.pair) return;
  EXPECT_EQ(one.pair->kind, many.pair->kind) << what;
  EXPECT_EQ(one.pair->vertices, many.pair->vertices) << what;
  EXPECT_EQ(one.pair->distance, many.pair->distance) << what;
}

Options one_thread() {
  Options options;
  options.threads = 1;
  return options;
}

/// Asks both everything about one step.
void expect_same_answers(Detector& one, distributed::Detector& many, const Scene& scene, const Part& part,
                         const std::string& what) {
  const auto expected = one.contacts(scene.step());
  many.contacts(part.step());
  const auto gathered = many.gather_contacts(0);
  if (rank_of() == 0)
    expect_same(expected, gathered, what);
  else
    EXPECT_TRUE(gathered.empty()) << what;
  expect_same(one.earliest(scene.step()), many.earliest(part.step()), what);
  EXPECT_EQ(one.is_free(scene.step()), many.is_free(part.step())) << what;
  for (const double fraction : {0.0, 0.1, 0.9})
    expect_same(one.keep_distance(scene.step(), fraction), many.keep_distance(part.step(), fraction), what);
}

class Equality : public testing::TestWithParam<Recipe> {};

TEST_P(Equality, EveryQuestionHasTheSameAnswerForEveryCut) {
  const Scene scene = GetParam().make(400, 1);
  Detector one(scene.mesh(), one_thread());
  for (const Cut& cut : cuts()) {
    const Part part = part_of(scene, cut);
    distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
    expect_same_answers(one, many, scene, part, cut.name);
  }
}

TEST_P(Equality, ADetectorThatIsKeptAnswersEveryStep) {
  Scene scene = GetParam().make(300, 2);
  Detector one(scene.mesh(), one_thread());
  Part part = part_of(scene, cuts()[0]);
  distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
  for (int step = 0; step < 4; ++step) {
    expect_same_answers(one, many, scene, part, "step " + std::to_string(step));
    // Back and forth, each time shifted: other vertices reach farthest.
    std::swap(scene.start, scene.end);
    for (std::size_t v = 0; v < scene.end.size(); v += 3) scene.end[v][static_cast<std::size_t>(step % 3)] += 0.05;
    part.move(scene.start, scene.end);
  }
}

TEST_P(Equality, SeparationThicknessAndFiltersReachAcrossRanks) {
  const Scene scene = GetParam().make(200, 3);
  Options options = one_thread();
  options.min_separation = 1e-3;
  options.filter = PairFilter::no_self_contact(scene.group_of_vertex);
  options.thickness.assign(static_cast<std::size_t>(options.filter.group_count), 2e-3);
  options.filter.accepts = [](PairKind, const std::array<Index, 4>& v) { return v[0] % 7 != 3; };
  Detector one(scene.mesh(), options);
  for (const Cut& cut : cuts()) {
    const Part part = part_of(scene, cut);
    Options local = options;
    local.filter.group_of_vertex = part.group_of_vertex;
    distributed::Detector many(MPI_COMM_WORLD, part.mesh, local);
    expect_same_answers(one, many, scene, part, cut.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Equality, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
