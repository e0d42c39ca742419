// A detector that has listed what is near at a start answers as one that was never asked before, bit for bit, and as
// one that looks at every pair.
#include <gtest/gtest.h>

#include "scenes/random.hpp"
#include "scenes/scene_list.hpp"
#include "support/as_new.hpp"
#include "support/test_data.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/components.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

/// A solver's iterations: the same start, and ends that are nearly the same, until it goes on from where it came to.
/// Now and then one vertex goes far, all do, or the step is another one.
struct Iterations {
  const Scene& scene;
  scenes::Random random;
  double length;
  std::vector<Point> start = scene.start, end = scene.start;

  void go_on() {
    const Index choice = random.below(12);
    if (choice < 2) start = choice == 0 ? end : between(scene.start, scene.end, random.unit());
    end = start;
    const double part = choice == 2 ? 1 : choice == 3 ? 0 : length * random.between(0.5, 1);
    for (std::size_t v = 0; v < end.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        end[v][k] += part * (scene.end[v][k] - scene.start[v][k]) * random.between(0.8, 1);
    if (choice == 4) end[static_cast<std::size_t>(random.below(scene.vertex_count()))] = scene.end[0];
  }
};

class PairsNearStart : public testing::TestWithParam<Recipe> {};

void expect_as_of_every_pair(const Scene& scene, const Detector& kept, const TruncatedStep& step, const Step& asked,
                             const QueryOptions& own, const std::string& where) {
  yardstick::Options options(kept.options());
  options.method = yardstick::Method::brute;
  Detector brute = yardstick::make_detector(scene.mesh(), options);
  const TruncatedStep expected = brute.truncate(asked, 0.1, own);
  EXPECT_EQ(step.positions, expected.positions) << where;
  EXPECT_EQ(step.fractions, expected.fractions) << where;
  EXPECT_EQ(step.is_free, expected.is_free) << where;
}

// Bugs: a vertex that goes farther than the lists allow; lists of another start, separation or fraction; a radius, or
// what a vertex keeps, left out of how far it reaches; pairs that the caller's filter left out while they were listed.
TEST_P(PairsNearStart, ChangeNoBitOfAnyAnswer) {
  const auto seeds = static_cast<std::uint64_t>(repetitions("TAMIS_JOURNEYS", 1));
  for (std::uint64_t seed = 5; seed < 5 + seeds; ++seed) {
    const Scene scene = GetParam().make(60, seed);
    for (const double separation : {0.0, 0x1p-9}) {
      scenes::Random random(seed);
      bool leaves_out_some = false;
      Options options;
      options.threads = 1 + random.below(2);
      if (separation > 0) give_radii(options, scene.vertex_count());
      options.filter.accepts = [&](PairKind, const std::array<Index, 4>& v) {
        return !leaves_out_some || v[0] % 3 != 0;
      };
      Detector kept(scene.mesh(), options);
      Iterations iterations{scene, random, separation > 0 ? 0x1p-6 : 0x1p-9};
      for (int i = 0; i < 20 && !HasFailure(); ++i) {
        iterations.go_on();
        leaves_out_some = i % 8 >= 6;
        const Step step{iterations.start, iterations.end};
        const QueryOptions own{.min_separation = separation * random.below(3) / 2,
                               .at_start = i % 3 == 2 ? AtStart::ignore : AtStart::report};
        const std::string where = scene.name + " " + std::to_string(seed) + ", question " + std::to_string(i);
        if (i % 5 == 4) expect_as_new(kept, step, Asked::safe_step, where, own);
        expect_as_of_every_pair(scene, kept, kept.truncate(step, 0.1, own), step, own, where);
      }
    }
  }
}

// Bug: lists that are made and never asked.
TEST(PairsNearOneStart, ServeAllTruncationsAfterTheSecond) {
  const Scene scene = scenes::scene_by_name("folded-cloth", 1000, 3);
  Detector kept(scene.mesh());
  const double first = kept.earliest(scene.step()).toi_lower;
  ASSERT_LT(first, 0.9);
  // The second truncation of a start lists its pairs; of the next start the first does.
  for (const double at : {0.999, 0.9995}) {
    const std::vector<Point> start = between(scene.start, scene.end, at * first);
    const int lists = at == 0.999 ? 1 : 0;
    for (const int i : {0, 1, 2, 3}) {
      const std::vector<Point> end = between(start, scene.end, i % 2 == 0 ? 0.02 : 0.01);
      EXPECT_NE(kept.truncate({start, end}).fractions, std::vector<double>(end.size(), 1)) << "nothing is held back";
      EXPECT_EQ(was_listed(kept), i > lists) << at << ", truncation " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PairsNearStart, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

}  // namespace
}  // namespace tamis::test
