// Pairs that touch at the start: reported, ignored until they have come apart, or refused. Against every pair decided
// exactly, by every method, question, instruction set and number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/exact.hpp"
#include "lab/detector.hpp"
#include "lab/pairs.hpp"
#include "query/pair_rules.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "support/as_new.hpp"
#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "tamis/error.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::test {
namespace {

using lab::Method;
using scenes::Recipe, scenes::Scene;

constexpr QueryOptions kIgnore{.at_start = AtStart::ignore}, kFail{.at_start = AtStart::fail};

lab::Options with(Method method, double separation) {
  lab::Options options;
  options.method = method;
  options.min_separation = separation;
  return options;
}

bool starts_touching(const Contact& contact) { return contact.toi_upper == 0; }

struct Truth {
  PairSet counted;
  std::uint64_t ignored = 0;
};
Truth truth_of(const Scene& scene, double separation) {
  Truth truth;
  lab::for_each_pair(scene.mesh(), {}, [&](PairKind kind, const PairVertices& v) {
    const PairPoints points = points_of(scene.step(), v);
    if (decide_once_apart_exactly(kind, points, separation).touches)
      truth.counted.insert({kind, v});
    else
      truth.ignored += decide_exactly(kind, points, separation).touches;
  });
  return truth;
}

/// Sheets on a coarse lattice that move by its units: corners that coincide, features that lie in each other, slide
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

// Bugs: a start that counts, a return that does not, in some method's way of its own past the decision of a pair.
TEST(AtStart, IgnoredPairsCountOnceApartByEveryMethod) {
  std::uint64_t ignored = 0, returned = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    for (const double separation : {0.0, 0.25, 0.3}) {
      const Scene scene = snapped_sheets(seed);
      const Truth truth = truth_of(scene, separation);
      for (const Method method : kMethods) {
        SCOPED_TRACE(std::string(name_of(method)) + ", seed " + std::to_string(seed));
        Detector detector = lab::make_detector(scene.mesh(), with(method, separation));
        const std::vector<Contact> reported = detector.contacts(scene.step());
        const std::vector<Contact> counted = detector.contacts(scene.step(), kIgnore);
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

// Bugs: a contact that does not start touching and has another bit; a thread, an instruction set or an earlier question
// that changes a bit; pairs that are ignored and not counted, or counted twice.
TEST_P(AtStartIn, NothingElseChanges) {
  Detector one = lab::make_detector(scene.mesh(), with(Method::tamis, separation));
  std::vector<Contact> reported = one.contacts(scene.step());
  const std::vector<Contact> counted = one.contacts(scene.step(), kIgnore);
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
    lab::Options options = with(Method::tamis, separation);
    options.threads = isa == Isa::best ? 2 : 1;
    options.isa = isa;
    Detector other = lab::make_detector(scene.mesh(), options);
    EXPECT_EQ(bits_of(other.contacts(scene.step(), kIgnore)), bits_of(counted));
    EXPECT_EQ(other.statistics().ignored, ignored);
    for (const Asked asked : {Asked::earliest, Asked::is_free, Asked::safe_step, Asked::contacts})
      expect_as_new(other, scene.step(), asked, scene.name, kIgnore);
  }
}

// Bugs: a pair without reserve that still ends the step at once, one that comes back and does not, a search that leaves
// such pairs out.
TEST_P(AtStartIn, StepLengthsAreThoseOfEveryPair) {
  const Scene few = GetParam().make(40, 23);
  for (const double fraction : {0.0, 0.1, 0.7}) {
    const SafeStep truth =
        lab::make_detector(few.mesh(), with(Method::brute, separation)).safe_step(few.step(), fraction, kIgnore);
    const SafeStep found =
        lab::make_detector(few.mesh(), with(Method::tamis, separation)).safe_step(few.step(), fraction, kIgnore);
    EXPECT_EQ(found.lower, truth.lower);
    EXPECT_EQ(found.upper, truth.upper);
    EXPECT_EQ(found.pair.has_value(), truth.pair.has_value());
    const EarliestContact first =
        lab::make_detector(few.mesh(), with(Method::tamis, separation)).earliest(few.step(), kIgnore);
    EXPECT_LE(found.lower, first.toi_upper);
  }
}

// Bugs: a way on which an ignored pair comes apart and back; one that stops where reported pairs would stop it.
TEST_P(AtStartIn, TruncatedStepsAreFreeOfWhatCounts) {
  const Scene few = GetParam().make(60, 29);
  Detector detector = lab::make_detector(few.mesh(), with(Method::tamis, separation));
  const TruncatedStep to = detector.truncate(few.step(), 0.1, kIgnore);
  EXPECT_TRUE(to.is_free);
  EXPECT_TRUE(detector.is_free({few.start, to.positions}, kIgnore));
  const TruncatedStep reported = detector.truncate(few.step(), 0.1);
  EXPECT_EQ(reported.is_free, detector.is_free({few.start, few.start}));
}

// Bugs: a question that does not fail, fails for what only comes to touch, or names another pair than the others do.
TEST_P(AtStartIn, EveryQuestionFailsForTheSamePair) {
  const Scene few = GetParam().make(60, 31);
  std::string first;
  for (const Method method : kMethods) {
    Detector detector = lab::make_detector(few.mesh(), with(method, separation));
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
    expect_failure("contacts", [&] { detector.contacts(few.step(), kFail); });
    expect_failure("earliest", [&] { detector.earliest(few.step(), kFail); });
    expect_failure("is_free", [&] { detector.is_free(few.step(), kFail); });
    if (method != Method::tamis) continue;  // the others ask it
    expect_failure("safe_step", [&] { detector.safe_step(few.step(), 0.1, kFail); });
    expect_failure("safe_step 0", [&] { detector.safe_step(few.step(), 0, kFail); });
    expect_failure("truncate", [&] { detector.truncate(few.step(), 0.1, kFail); });
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AtStartIn, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

/// A point that moves against a triangle, and another triangle beside it.
struct OnAFace : testing::Test {
  Mesh mesh{7, {{0, 1, 2}, {4, 5, 6}}, {}, {3}};
  std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}, {3, 0, 0}, {4, 0, 0}, {3, 1, 0}},
      end = start;
};

// Bugs: a sentence without the pair, the separation or advice; an answer that is refused where nothing touches.
TEST_F(OnAFace, FailureNamesThePair) {
  const auto sentence_of = [&](double separation) -> std::string {
    Detector detector(mesh);
    try {
      detector.contacts({start, end}, {.min_separation = separation, .at_start = AtStart::fail});
    } catch (const InvalidStep& refusal) {
      return refusal.what();
    }
    return "";
  };
  EXPECT_EQ(sentence_of(0),
            "vertex 3 and face 0 1 2 touch at the start of the step: move them apart, leave the pair out, or ask with "
            "at_start ignore");
  EXPECT_NE(sentence_of(0.125).find("within 0.125 of each other"), std::string::npos);
  start[3][2] = end[3][2] = 0.5;
  EXPECT_EQ(sentence_of(0.125), "");
  EXPECT_NE(sentence_of(0.5).find("vertex 3 and face 0 1 2"), std::string::npos);
  end[3][2] = -0.5;
  EXPECT_EQ(sentence_of(0), "") << "what only comes to touch";
}

// Bugs: radii that are left out of what touches at the start.
TEST_F(OnAFace, RadiiCountAtTheStart) {
  start[3][2] = 0.25;
  end[3][2] = 1;
  Options options;
  options.radii = {0.125};
  Detector detector(mesh, options);
  EXPECT_FALSE(detector.is_free({start, end}));
  EXPECT_TRUE(detector.is_free({start, end}, kIgnore));
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_THROW(detector.is_free({start, end}, kFail), InvalidStep);
}

// Bugs: a curve that is asked as if pairs that touch at its start were to be reported.
TEST_F(OnAFace, CurvesIgnoreAndFailToo) {
  class Still : public Path {
   public:
    explicit Still(const std::vector<Point>& points) : points_(points) {}
    Index vertex_count() const override { return static_cast<Index>(points_.size()); }
    void points_at(double, std::span<const Index> vertices, std::span<Point> points,
                   std::span<double> errors) const override {
      for (std::size_t i = 0; i < vertices.size(); ++i) points[i] = points_[static_cast<std::size_t>(vertices[i])];
      std::ranges::fill(errors, 0);
    }
    void deviations(double, double, std::span<const Index>, std::span<double> deviations) const override {
      std::ranges::fill(deviations, 0);
    }

   private:
    const std::vector<Point>& points_;
  };
  Detector detector(mesh);
  const Still path(start);
  EXPECT_FALSE(detector.is_free(path));
  EXPECT_EQ(detector.statistics().ignored, 0u);
  EXPECT_TRUE(detector.contacts(path, kIgnore).empty());
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_FALSE(detector.earliest(path, kIgnore).contact);
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_TRUE(detector.is_free(path, kIgnore));
  EXPECT_EQ(detector.statistics().ignored, 1u);
  EXPECT_THROW(detector.contacts(path, kFail), InvalidStep);
  EXPECT_THROW(detector.earliest(path, kFail), InvalidStep);
  EXPECT_THROW(detector.is_free(path, kFail), InvalidStep);
  EXPECT_THROW(detector.is_free({start, end}, {.tolerance = 1e-9}), InvalidOptions);
}

// Bugs: pairs that are ignored and not counted; one that is counted though it comes back, in a later piece of the path,
// or once in each piece.
TEST(AtStart, OnACurveWhatDoesNotComeBackIsIgnoredAndCountedOnce) {
  // A face, and points: one stays on it, one leaves it, one goes round and comes back, one comes from above.
  const std::vector<Point> rest{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {3, 1, 0}, {2, 0, -1}, {1, 3, 1}};
  const Pose still{{0, 0, 0}, {0, 0, 0}};
  const double whole_turn = 2 * std::acos(-1.0);
  const RigidPath path(rest, {0, 0, 0, 0, 1, 2, 3},
                       {{},
                        interpolated(still, {{0, 0, 1}, {0, 0, 0}}),
                        interpolated({{0, 2, 1}, {0, 0, 0}}, {{0, 2, 1}, {whole_turn, 0, 0}}),
                        interpolated(still, {{0, 0, -1}, {0, 0, 0}})});
  Detector detector(Mesh(7, {{0, 1, 2}}, {}, {3, 4, 5, 6}));
  QueryOptions ignore = kIgnore;
  ignore.min_separation = 0.01;
  const std::vector<Contact>& contacts = detector.contacts(path, ignore);
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].vertices[0], 5);
  EXPECT_EQ(contacts[1].vertices[0], 6);
  EXPECT_EQ(detector.statistics().ignored, 2u);
}

// Bug: is_free ends at a first contact, before it has looked at the pair that touches at the start.
// Bug: they were counted again with each beginning of the step that was looked at.
TEST(AtStart, IsCountedOnceWhereAStepGoesVeryFar) {
  const std::vector<Point> start{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}, {0, 0, 0}, {0.5, 0, 0}, {-0.5, 0, 0}};
  for (const double far : {1.0, 1e5, 1e9}) {
    std::vector<Point> end = start;
    for (const std::size_t v : {3u, 4u, 5u}) end[v][2] += far;
    Detector detector(Mesh(6, {{0, 1, 2}}, {}, {3, 4, 5}));
    for (int time = 0; time < 3; ++time) {
      EXPECT_FALSE(detector.earliest({start, end}, kIgnore).contact);
      EXPECT_EQ(detector.statistics().ignored, 3u) << far << ' ' << time;
    }
  }
}

TEST(AtStart, FailsOnACurveThoughOthersTouchLater) {
  for (const Index later : {7, 8, 9, 40}) {
    std::vector<Point> rest{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
    for (Index i = 0; i < later; ++i) rest.push_back({0.1 + 0.1 * i, 0.1, 0.01});
    rest.push_back({1, 1, 0});
    std::vector<Index> points(rest.size() - 3), body_of_vertex(rest.size(), 1);
    std::iota(points.begin(), points.end(), 3);
    std::fill_n(body_of_vertex.begin(), 3, 0);
    Detector detector(Mesh(static_cast<Index>(rest.size()), {{0, 1, 2}}, {}, points));
    const RigidPath path(rest, body_of_vertex, {{}, interpolated({}, {{0, 0, -1}, {0, 0, 0.1}})});
    EXPECT_THROW(detector.is_free(path, kFail), InvalidStep) << later;
    EXPECT_FALSE(detector.is_free(path)) << later;
  }
}

/// A sheet that starts on a ball, within the separation, is thrown up and falls back.
struct Throw {
  Scene scene;
  std::size_t ball = 0;  ///< vertices before the sheet's
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
  double height() const { return x[ball + 24][2] - 1; }  // of the middle of the sheet
};

// Bugs: a sheet that never leaves what it starts on, leaves it and falls through, or is held by what it has left.
TEST(AtStart, AClothThatStartsOnABallLeavesItAndLandsOnIt) {
  constexpr double kSeparation = 0x1p-6, kStep = 1.0 / 64;
  Throw sheet(kSeparation / 2);
  Detector detector = lab::make_detector(sheet.scene.mesh(), with(Method::tamis, kSeparation));
  double highest = 0;
  std::uint64_t ignored = 0;
  for (int step = 0; step < 40; ++step) {
    const std::vector<Point> end = sheet.wanted(kStep);
    if (step == 0) {
      EXPECT_EQ(detector.safe_step({sheet.x, end}, 0.1).lower, 0);
      EXPECT_EQ(detector.safe_step({sheet.x, end}, 0.1, kIgnore).lower, 1);
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
