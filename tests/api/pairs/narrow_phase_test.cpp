// Lists of pairs. Would catch: a lane that decides otherwise than one pair alone, a result in another pair's place, a
// pair whose answer depends on its neighbours in the list, an index or a coordinate that is read before it is checked.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "scenes/scene_list.hpp"
#include "support/ask_pair.hpp"
#include "support/contact_sets.hpp"
#include "support/pair_cases.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis {
namespace {

constexpr Isa kIsas[] = {Isa::baseline, Isa::avx2, Isa::avx512};

bool is_here(Isa isa) {
  try {
    (void)narrow_phase(std::vector<FeaturePair>{}, Step{}, {.isa = isa});
    return true;
  } catch (const InvalidOptions&) {
    return false;
  }
}

/// Names the first number in which two results differ; empty if they are equal bit for bit.
std::string difference(const PairResult& a, const PairResult& b) {
  if (a.touches != b.touches) return "touches";
  if (a.certainty != b.certainty) return "certainty";
  if (a.toi_lower != b.toi_lower || a.toi_upper != b.toi_upper) return "bracket";
  if (a.u != b.u || a.v != b.v) return "weights";
  return a.normal == b.normal ? "" : "normal";
}

/// A motion as in a diverging simulation: each vertex goes `times` as far. Unchanged if a coordinate became too large.
oracle::Motion exploding(const oracle::Motion& motion, double times) {
  oracle::Motion far = motion;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      far.end[i][k] = motion.start[i][k] + times * (motion.end[i][k] - motion.start[i][k]);
      if (!(std::fabs(far.end[i][k]) < 0x1p1000)) return motion;
    }
  return far;
}

/// Motions of all kinds and families, and a list in which the kinds alternate. Every third motion goes very far.
struct Cases {
  std::vector<Point> start, end;
  std::vector<FeaturePair> pairs;
  std::vector<oracle::Motion> motions;
};

void add_case(PairKind kind, const oracle::Motion& motion, Cases& cases) {
  const auto first = static_cast<Index>(cases.start.size());
  cases.start.insert(cases.start.end(), motion.start.begin(), motion.start.end());
  cases.end.insert(cases.end.end(), motion.end.begin(), motion.end.end());
  cases.pairs.push_back({kind, {first, first + 1, first + 2, first + 3}});
  cases.motions.push_back(motion);
}

Cases make_cases(int count) {
  test::Random random(7);
  Cases cases;
  for (int i = 0; i < count; ++i)
    for (const auto& family : test::kFamilies)
      for (const PairKind kind : test::kAllKinds) {
        const oracle::Motion placed =
            test::placed(family.make(kind, random), test::kPlacements[static_cast<std::size_t>(random.below(6))]);
        const oracle::Motion motion = i % 3 == 0 ? exploding(placed, std::ldexp(1, 4 + random.below(40))) : placed;
        add_case(kind, motion, cases);
      }
  return cases;
}

/// Cases with coordinates so large that their differences overflow.
Cases make_overflowing_cases(int count) {
  test::Random random(8);
  Cases cases;
  for (int i = 0; i < count; ++i)
    for (const PairKind kind : test::kAllKinds) {
      oracle::Motion motion;
      for (auto* points : {&motion.start, &motion.end})
        for (Point& p : *points)
          for (double& x : p) x = 0x1p1023 * random.between(-1.9, 1.9);
      add_case(kind, motion, cases);
    }
  return cases;
}

/// What the functions for one pair say of each.
std::vector<PairResult> asked_alone(const Cases& cases, const PairOptions& options) {
  std::vector<PairResult> results;
  for (std::size_t i = 0; i < cases.pairs.size(); ++i)
    results.push_back(test::ask_pair(cases.pairs[i].kind, cases.motions[i], options));
  return results;
}

void expect_bits_of_single_pairs(const Cases& cases) {
  for (const double separation : {0.0, 1e-300, 1e-9, 0.01, 0.125, 3.0})
    for (const double latest : {1.0, 0.25}) {
      const auto alone = asked_alone(cases, {separation, latest});
      for (const Isa isa : kIsas) {
        if (!is_here(isa)) continue;
        const auto results = narrow_phase(cases.pairs, {cases.start, cases.end},
                                          {.min_separation = separation, .latest = latest, .threads = 1, .isa = isa});
        ASSERT_EQ(results.size(), alone.size());
        for (std::size_t i = 0; i < results.size(); ++i)
          ASSERT_EQ(difference(results[i], alone[i]), "")
              << "pair " << i << ", " << name_of(isa) << ", separation " << separation << ", latest " << latest << '\n'
              << test::describe(cases.pairs[i].kind, cases.motions[i]);
      }
    }
}

TEST(NarrowPhase, ListsSayBitForBitWhatTheFunctionsForOnePairSay) { expect_bits_of_single_pairs(make_cases(20)); }

// Bug: lanes leave pairs with overflowing differences undecided. Crossings can decide them in a smaller unit, but were
// skipped as if the lanes had tried them.
TEST(NarrowPhase, ListsSayTheSameWhereDifferencesOverflow) { expect_bits_of_single_pairs(make_overflowing_cases(100)); }

TEST(NarrowPhase, ThreadsAndPlacesInTheListChangeNoBit) {
  const Cases cases = make_cases(500);  // so many that threads share them
  const auto results = narrow_phase(cases.pairs, {cases.start, cases.end}, {.threads = 1});
  const auto threads = narrow_phase(cases.pairs, {cases.start, cases.end}, {.threads = 3});
  std::vector<FeaturePair> reversed(cases.pairs.rbegin(), cases.pairs.rend());
  const auto backwards = narrow_phase(reversed, {cases.start, cases.end});
  for (std::size_t i = 0; i < results.size(); ++i) {
    ASSERT_EQ(difference(results[i], threads[i]), "") << i;
    ASSERT_EQ(difference(results[i], backwards[results.size() - 1 - i]), "") << i;
  }
}

TEST(NarrowPhase, ListsOfADetectorsPairsTouchWhereItFindsContacts) {
  const scenes::Scene scene = scenes::scene_by_name("folded-cloth", 800, 3);
  const test::PairSet contacts = test::find_names(scene, {});
  std::vector<FeaturePair> pairs;
  yardstick::Options options;
  options.method = yardstick::Method::brute;
  options.threads = 1;
  options.filter.accepts = [&](PairKind kind, const std::array<Index, 4>& vertices) {
    pairs.push_back({kind, vertices});
    return false;
  };
  test::find_names(scene, options);
  const auto results = narrow_phase(pairs, scene.step());
  test::PairSet touching;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (results[i].touches) touching.insert({pairs[i].kind, pairs[i].vertices});
  EXPECT_GT(contacts.size(), 0u);
  EXPECT_TRUE(touching == contacts);
}

TEST(NarrowPhase, StridesAreFollowedAndRowsThatNoPairNamesAreNotRead) {
  const Cases cases = make_cases(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> start, end;
  for (std::size_t i = 0; i < cases.start.size(); ++i)
    for (const auto& [from, to] : {std::pair(&cases.start, &start), std::pair(&cases.end, &end)}) {
      to->insert(to->end(), (*from)[i].begin(), (*from)[i].end());
      to->insert(to->end(), to == &start ? 2 : 1, nan);
    }
  start.insert(start.end(), 5, nan);
  end.insert(end.end(), 4, nan);
  const auto count = static_cast<Index>(cases.start.size()) + 1;
  const Step step{{start.data(), count, 5}, {end.data(), count, 4}};
  const auto results = narrow_phase(cases.pairs, step);
  const auto expected = narrow_phase(cases.pairs, {cases.start, cases.end});
  for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(difference(results[i], expected[i]), "") << i;
}

TEST(NarrowPhase, AnEmptyListHasNoResults) { EXPECT_TRUE(narrow_phase(std::vector<FeaturePair>{}, Step{}).empty()); }

template <class Bad>
std::string sentence(std::vector<FeaturePair> pairs, const Step& step, const PairOptions& options = {}) {
  try {
    (void)narrow_phase(pairs, step, options);
  } catch (const Bad& e) {
    return e.what();
  }
  return "nothing was thrown";
}

TEST(NarrowPhase, BadPairsAreNamedTheFirstOfThem) {
  const Cases cases = make_cases(300);
  const Step step{cases.start, cases.end};
  const std::string count = std::to_string(cases.start.size());
  auto pairs = cases.pairs;
  pairs[9000].vertices[1] = -1;
  pairs[11000].vertices[0] = static_cast<Index>(cases.start.size());
  EXPECT_EQ(sentence<InvalidStep>(pairs, step), "pair 9000: vertex -1 is not a row of the step's " + count +
                                                    " positions: give indices in [0, " + count + ")");
  pairs[70].kind = static_cast<PairKind>(kPairKinds);
  EXPECT_EQ(sentence<InvalidStep>(pairs, step),
            "pair 70: unknown kind number " + std::to_string(kPairKinds) + ": use one of the enumeration's names");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (std::size_t place = 0; place < 4; ++place) {
      auto end = cases.end;
      const auto vertex = static_cast<std::size_t>(cases.pairs[41].vertices[place]);
      end[vertex][place % 3] = bad;
      EXPECT_EQ(sentence<InvalidStep>(cases.pairs, {cases.start, end}),
                "pair 41: vertex " + std::to_string(vertex) +
                    " at the end of the step has a coordinate that is not finite: give finite positions");
    }
}

TEST(NarrowPhase, VerticesThatAKindDoesNotUseAreNotRead) {
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}}, end{{1, 0, 0}, {1, 0, 0}};
  const auto results = narrow_phase(std::vector<FeaturePair>{{PairKind::vertex_vertex, {0, 1, -7, 99}}}, {start, end});
  EXPECT_TRUE(results[0].touches);
}

TEST(NarrowPhase, PairsThatComeAsPointsSayTheSame) {
  const Cases cases = make_cases(300);
  for (const PairKind kind : test::kAllKinds) {
    const std::size_t corners = kind == PairKind::vertex_vertex ? 2 : kind == PairKind::vertex_edge ? 3 : 4;
    std::vector<Point> start, end;
    std::vector<FeaturePair> pairs;
    for (const FeaturePair& pair : cases.pairs)
      if (pair.kind == kind) {
        for (std::size_t i = 0; i < corners; ++i) {
          start.push_back(cases.start[static_cast<std::size_t>(pair.vertices[i])]);
          end.push_back(cases.end[static_cast<std::size_t>(pair.vertices[i])]);
        }
        pairs.push_back(pair);
      }
    std::vector<PairResult> results(pairs.size());
    narrow_phase(kind, start, end, results);
    const auto expected = narrow_phase(pairs, {cases.start, cases.end});
    for (std::size_t i = 0; i < pairs.size(); ++i) ASSERT_EQ(difference(results[i], expected[i]), "") << i;
    start[corners * 5 + 1][2] = std::numeric_limits<double>::quiet_NaN();
    try {
      narrow_phase(kind, start, end, results);
      FAIL() << "nothing was thrown";
    } catch (const InvalidStep& e) {
      EXPECT_STREQ(e.what(), "pair 5: point 1 at the start of the step is not finite: give finite coordinates");
    }
    start.pop_back();
    EXPECT_THROW(narrow_phase(kind, start, end, results), InvalidStep);
  }
}

// Bug: is_cancelled is not called between hard pairs. Points that all pass the origin at once take longest to decide.
TEST(NarrowPhase, IsCancelledBetweenHardPairsToo) {
  constexpr std::size_t kPairs = 40;  // less than a batch of the lanes
  std::vector<Point> start(4 * kPairs), end(start.size());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (std::size_t i = 0; i < start.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) end[i][axis] = -(start[i][axis] = coordinate(random));
  int asked = 0;
  std::vector<PairResult> results(kPairs);
  EXPECT_THROW(narrow_phase(PairKind::edge_edge, start, end, results,
                            {.threads = 1, .is_cancelled = [&] { return ++asked == 20; }}),
               Cancelled);
}

TEST(NarrowPhase, ACancelledListThrows) {
  const Cases cases = make_cases(1);
  EXPECT_THROW((void)narrow_phase(cases.pairs, {cases.start, cases.end}, {.is_cancelled = [] { return true; }}),
               Cancelled);
}

TEST(NarrowPhase, BadStepsAndOptionsAreRefused) {
  const std::vector<Point> two(2), three(3);
  EXPECT_EQ(sentence<InvalidStep>({}, {two, three}),
            "the step has 2 positions at its start and 3 at its end: give as many");
  EXPECT_NE(sentence<InvalidStep>({}, {{nullptr, 2}, two}).find("the start of the step is not an n x 3 array"),
            std::string::npos);
  EXPECT_NE(sentence<InvalidOptions>({}, {}, {.min_separation = -1}).find("give a finite distance"), std::string::npos);
  EXPECT_NE(sentence<InvalidOptions>({}, {}, {.threads = -1}).find("threads is -1"), std::string::npos);
  std::vector<PairResult> results(1);
  EXPECT_THROW(narrow_phase({}, Step{}, results), InvalidStep);
}

}  // namespace
}  // namespace tamis
