// Pairs that touch at the start: reported, ignored until they have come apart, or refused. Compares all methods,
// questions, instruction sets and numbers of threads with exact decisions of every pair.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "api/at_start/at_start_options.hpp"
#include "pair/exact/exact.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "search/query/pair_vertices.hpp"
#include "support/as_new.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "support/yardstick/pairs.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;
using yardstick::Method;

bool starts_touching(const Contact& contact) { return contact.toi_upper == 0; }

struct Truth {
  PairSet counted;
  std::uint64_t ignored = 0;
};
Truth truth_of(const Scene& scene, double separation) {
  Truth truth;
  yardstick::for_each_pair(scene.mesh(), {}, [&](PairKind kind, const PairVertices& v) {
    const PairPoints points = points_of(scene.step(), v);
    if (decide_recontact_exactly(kind, points, separation).touches())
      truth.counted.insert({kind, v});
    else
      truth.ignored += decide_exactly(kind, points, separation).touches();
  });
  return truth;
}

/// Sheets on a coarse lattice that move by multiples of its unit: corners coincide; features lie in each other, slide
/// along each other, pass through each other, and stay as they are.
Scene snapped_sheets(std::uint64_t seed) {
  constexpr double kUnit = 0.25;
  scenes::Random random(seed);
  Scene scene;
  scene.name = "snapped sheets";
  for (Index sheet = 0; sheet < 3; ++sheet) {
    const Index first = scene.vertex_count();
    const Point shift = random.point_on_lattice(2, kUnit), way = random.point_on_lattice(2, kUnit);
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 3; ++j) {
        const Point bump = random.point_on_lattice(1, kUnit), own = random.point_on_lattice(random.below(2), kUnit);
        const Point start{2 * kUnit * i + shift[0] + bump[0], 2 * kUnit * j + shift[1] + bump[1], shift[2] + bump[2]};
        scene.add_vertex(start, {start[0] + way[0] + own[0], start[1] + way[1] + own[1], start[2] + way[2] + own[2]},
                         0);
      }
    scenes::add_grid_faces(scene, first, 3, 3);
  }
  return scene;
}

// Bugs: where a method bypasses the decision of a pair, a contact at the start that counts, or a return that does not.
TEST(AtStart, IgnoredPairsCountOnceApartByEveryMethod) {
  std::uint64_t ignored = 0, returned = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    for (const double separation : {0.0, 0.25, 0.3}) {
      const Scene scene = snapped_sheets(seed);
      const Truth truth = truth_of(scene, separation);
      for (const Method method : kMethods) {
        SCOPED_TRACE(std::string(name_of(method)) + ", seed " + std::to_string(seed));
        Detector detector = yardstick::make_detector(scene.mesh(), with(method, separation));
        const std::vector<Contact> reported = copied(detector.contacts(scene.step()));
        const std::vector<Contact> counted = copied(detector.contacts(scene.step(), kIgnore));
        EXPECT_EQ(missing(truth.counted, names_of(counted)), "") << "missed";
        EXPECT_EQ(missing(names_of(counted), truth.counted), "") << "made up";
        EXPECT_EQ(detector.statistics().ignored, truth.ignored);
        EXPECT_EQ(detector.is_free(scene.step(), kIgnore), counted.empty());
        const EarliestContact first = detector.earliest(scene.step(), kIgnore);
        EXPECT_EQ(first.contact.has_value(), !counted.empty());
        const auto earlier = [](const Contact& a, const Contact& b) { return a.toi_lower < b.toi_lower; };
        if (!counted.empty()) {
          EXPECT_NEAR(first.toi_lower, std::ranges::min_element(counted, earlier)->toi_lower, 1e-9);
        }
        ignored += truth.ignored;
        returned += static_cast<std::size_t>(std::ranges::count_if(reported, starts_touching)) - truth.ignored;
      }
    }
  EXPECT_GT(ignored, 100u);
  EXPECT_GT(returned, 10u);
}

class AtStartIn : public testing::TestWithParam<Recipe> {
 protected:
  const Scene scene = GetParam().make(GetParam().scales ? 400 : 120, 19);
  const double separation = 0x1p-5;
};

// Bugs: other bits of a contact that does not touch at the start; a thread, an instruction set or an earlier question
// that changes a bit; ignored pairs that are not counted, or counted twice.
TEST_P(AtStartIn, NothingElseChanges) {
  Detector one = yardstick::make_detector(scene.mesh(), with(Method::tamis, separation));
  std::vector<Contact> reported = copied(one.contacts(scene.step()));
  const std::vector<Contact> counted = copied(one.contacts(scene.step(), kIgnore));
  const std::uint64_t ignored = one.statistics().ignored;
  PairSet starting;
  for (const Contact& c : reported)
    if (starts_touching(c)) starting.insert({c.kind, c.vertices});
  std::vector<Contact> others = counted;
  std::erase_if(others, [&](const Contact& c) { return starting.contains({c.kind, c.vertices}); });
  const std::size_t all = reported.size();
  std::erase_if(reported, starts_touching);
  EXPECT_EQ(bits_of(others), bits_of(reported));
  EXPECT_EQ(counted.size() + ignored, all);
  for (const Isa isa : {Isa::best, Isa::baseline}) {
    yardstick::Options options = with(Method::tamis, separation);
    options.threads = isa == Isa::best ? 2 : 1;
    options.isa = isa;
    Detector other = yardstick::make_detector(scene.mesh(), options);
    EXPECT_EQ(bits_of(other.contacts(scene.step(), kIgnore)), bits_of(counted));
    EXPECT_EQ(other.statistics().ignored, ignored);
    for (const Asked asked : {Asked::earliest, Asked::is_free, Asked::safe_step, Asked::contacts})
      expect_as_new(other, scene.step(), asked, scene.name, kIgnore);
  }
}

// Bugs: a pair without clearance at the start that still ends the step at once; one that comes back and does not end
// the step; a search that leaves such pairs out.
TEST_P(AtStartIn, StepLengthsAreThoseOfEveryPair) {
  const Scene few = GetParam().make(40, 23);
  for (const double fraction : {0.0, 0.1, 0.7}) {
    const SafeStep truth =
        yardstick::make_detector(few.mesh(), with(Method::brute, separation)).safe_step(few.step(), fraction, kIgnore);
    const SafeStep found =
        yardstick::make_detector(few.mesh(), with(Method::tamis, separation)).safe_step(few.step(), fraction, kIgnore);
    EXPECT_EQ(found.toi_lower, truth.toi_lower);
    EXPECT_EQ(found.toi_upper, truth.toi_upper);
    EXPECT_EQ(found.pair.has_value(), truth.pair.has_value());
    const EarliestContact first =
        yardstick::make_detector(few.mesh(), with(Method::tamis, separation)).earliest(few.step(), kIgnore);
    EXPECT_LE(found.toi_lower, first.toi_upper);
  }
}

// Bugs: a truncated step in which an ignored pair comes apart and back; one that ends as if the pair were reported.
TEST_P(AtStartIn, TruncatedStepsAreFreeOfWhatCounts) {
  const Scene few = GetParam().make(60, 29);
  Detector detector = yardstick::make_detector(few.mesh(), with(Method::tamis, separation));
  const TruncatedStep to = detector.truncate(few.step(), 0.1, kIgnore);
  EXPECT_TRUE(to.is_free);
  EXPECT_TRUE(detector.is_free({few.start, to.positions}, kIgnore));
  const TruncatedStep reported = detector.truncate(few.step(), 0.1);
  EXPECT_EQ(reported.is_free, detector.is_free({few.start, few.start}));
}

// Bugs: a question that does not fail, that fails for a pair which touches only later, or that names another pair than
// the other questions do.
TEST_P(AtStartIn, EveryQuestionFailsForTheSamePair) {
  const Scene few = GetParam().make(60, 31);
  std::string first;
  for (const Method method : kMethods) {
    Detector detector = yardstick::make_detector(few.mesh(), with(method, separation));
    const bool touches = !detector.is_free({few.start, few.start});
    const auto expect_failure = [&](const char* what, const auto& ask) {
      try {
        ask();
        EXPECT_FALSE(touches) << what;
      } catch (const InvalidStep& refusal) {
        EXPECT_TRUE(touches) << what << ": " << refusal.what();
        if (first.empty()) first = refusal.what();
        EXPECT_EQ(refusal.what(), first) << what;
      }
    };
    expect_failure("contacts", [&] { (void)detector.contacts(few.step(), kFail); });
    expect_failure("earliest", [&] { (void)detector.earliest(few.step(), kFail); });
    expect_failure("is_free", [&] { (void)detector.is_free(few.step(), kFail); });
    if (method != Method::tamis) continue;  // the others ask it
    expect_failure("safe_step", [&] { (void)detector.safe_step(few.step(), 0.1, kFail); });
    expect_failure("safe_step 0", [&] { (void)detector.safe_step(few.step(), 0, kFail); });
    expect_failure("truncate", [&] { (void)detector.truncate(few.step(), 0.1, kFail); });
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AtStartIn, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

/// A sheet on a ball: it starts within the separation, is thrown up and falls back.
struct Throw {
  Scene scene;
  std::size_t ball = 0;  ///< number of the ball's vertices, which come before the sheet's
  std::vector<Point> x, velocity;

  explicit Throw(double gap) {
    const scenes::Shape sphere = scenes::unit_sphere(4);
    const auto same = [](const Point& p) { return p; };
    scenes::add_shape(scene, sphere, 0, same, same);
    ball = scene.start.size();
    constexpr Index kRows = 7;
    for (Index i = 0; i < kRows; ++i)
      for (Index j = 0; j < kRows; ++j) {
        const Point p{0.2 * (i - 3), 0.2 * (j - 3), 1 + gap};
        scene.add_vertex(p, p, 1);
      }
    scenes::add_grid_faces(scene, static_cast<Index>(ball), kRows, kRows);
    x = scene.start;
    velocity.assign(x.size(), Point{});
    for (std::size_t v = ball; v < x.size(); ++v) velocity[v] = {0, 0, 1.5};
  }

  std::vector<Point> wanted(double h) {
    std::vector<Point> end = x;
    for (std::size_t v = ball; v < x.size(); ++v) {
      velocity[v][2] -= 10 * h;
      for (std::size_t k = 0; k < 3; ++k) end[v][k] += h * velocity[v][k];
    }
    return end;
  }
  double height() const { return x[ball + 24][2] - 1; }  // of the sheet's middle vertex above the ball
};

// Bugs: a sheet that never leaves the ball on which it starts, that falls through it later, or that is held by it after
// it has left.
TEST(AtStart, AClothThatStartsOnABallLeavesItAndLandsOnIt) {
  constexpr double kSeparation = 0x1p-6, kStep = 1.0 / 64;
  Throw sheet(kSeparation / 2);
  Detector detector = yardstick::make_detector(sheet.scene.mesh(), with(Method::tamis, kSeparation));
  double highest = 0;
  std::uint64_t ignored = 0;
  for (int step = 0; step < 40; ++step) {
    const std::vector<Point> end = sheet.wanted(kStep);
    if (step == 0) {
      EXPECT_EQ(detector.safe_step({sheet.x, end}, 0.1).toi_lower, 0);
      EXPECT_EQ(detector.safe_step({sheet.x, end}, 0.1, kIgnore).toi_lower, 1);
    }
    const TruncatedStep to = detector.truncate({sheet.x, end}, 0.1, kIgnore);
    EXPECT_TRUE(detector.is_free({sheet.x, to.positions}, kIgnore));
    ignored += detector.statistics().ignored;
    sheet.x = to.positions;
    highest = std::max(highest, sheet.height());
  }
  EXPECT_GT(ignored, 0u);
  EXPECT_GT(highest, 2 * kSeparation);
  EXPECT_GT(sheet.height(), 0) << "it has fallen through";
  EXPECT_LT(sheet.height(), highest / 2) << "it has not come back";
  EXPECT_TRUE(detector.is_free({sheet.x, sheet.x})) << "within the separation again";
}

}  // namespace
}  // namespace tamis::test
