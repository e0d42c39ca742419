// The answer of many ranks is that of one process, bit for bit, whoever has what.
#include <gtest/gtest.h>

#include "distributed/tests/same_answers.hpp"
#include "support/test_names.hpp"
#include "tamis/detector.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

class Equality : public testing::TestWithParam<Recipe> {};

TEST_P(Equality, EveryQuestionHasTheSameAnswerForEveryCut) {
  expect_same_for_all_cuts(GetParam().make(250, 1), one_thread());
}

TEST_P(Equality, ADetectorThatIsKeptAnswersEveryStep) {
  Scene scene = GetParam().make(150, 2);
  Detector one(scene.mesh(), one_thread());
  Part part = part_of(scene, cuts()[0]);
  distributed::Detector many(MPI_COMM_WORLD, part.mesh, one_thread());
  for (int step = 0; step < 4; ++step) {
    expect_same_answers(answers_of(one, scene), many, part, "step " + std::to_string(step));
    // Back and forth, each time shifted: other vertices reach farthest.
    std::swap(scene.start, scene.end);
    for (std::size_t v = 0; v < scene.end.size(); v += 3) scene.end[v][static_cast<std::size_t>(step % 3)] += 0.05;
    part.move(scene.start, scene.end);
  }
}

TEST_P(Equality, SeparationThicknessAndFiltersReachAcrossRanks) {
  const Scene scene = GetParam().make(120, 3);
  Options options = one_thread();
  options.min_separation = 1e-3;
  options.filter = PairFilter::no_self_contact(scene.group_of_vertex);
  options.radii.assign(static_cast<std::size_t>(options.filter.group_count), 2e-3);
  options.filter.accepts = [](PairKind, const std::array<Index, 4>& v) { return v[0] % 7 != 3; };
  expect_same_for_all_cuts(scene, options);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Equality, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
