// Bad input is refused by an exception of a documented type, with a sentence that names the culprit.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <thread>

#include "scenes/random.hpp"
#include "support/contact_sets.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/components.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"

namespace tamis::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using scenes::Scene;

/// The message of the exception that `action` throws; a failure if it throws none of this type.
template <class Exception, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Exception& exception) {
    return exception.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

class BadInput : public testing::TestWithParam<Method> {
 protected:
  BadInput() { options.method = GetParam(); }
  Scene scene = scenes::scene_by_name("soup", 5, 1);
  yardstick::Options options;
};

TEST_P(BadInput, PositionsThatDoNotFitTheMesh) {
  Detector detector = yardstick::make_detector(scene.mesh(), options);
  std::vector<Point> fewer = scene.end;
  fewer.pop_back();
  const Step step{scene.start, fewer};
  EXPECT_NE(message_of<InvalidStep>([&] { (void)detector.contacts(step); }).find("14"), std::string::npos);
  EXPECT_THROW((void)detector.earliest(step), InvalidStep);
  EXPECT_THROW((void)detector.is_free(step), InvalidStep);
}

/// As many positions as an Index would count as none, where there can be so many.
constexpr std::size_t kBeyondIndices = std::size_t{1} << (sizeof(std::size_t) > 4 ? 32 : 31);

// Bug: 2^32 positions too many went unnoticed, because the count was truncated to 32 bits.
TEST_P(BadInput, MorePositionsThanAnIndexCounts) {
  Detector detector = yardstick::make_detector(scene.mesh(), options);
  const std::span<const Point> too_many(scene.start.data(), scene.start.size() + kBeyondIndices);
  EXPECT_NE(message_of<InvalidStep>([&] {
              (void)detector.contacts({too_many, too_many});
            }).find("2^31"),
            std::string::npos);
}

// Bug: a list of pairs took too many positions for 2^32 - 1 rows, and read beyond the end.
TEST(BadInputOfLists, MorePositionsThanAnIndexCounts) {
  const Scene scene = scenes::scene_by_name("soup", 5, 1);
  const std::span<const Point> too_many(scene.start.data(), scene.start.size() + kBeyondIndices);
  const std::vector<FeaturePair> pairs{{PairKind::vertex_vertex, {0, 1}}};
  const auto ask = [&] { (void)narrow_phase(pairs, {too_many, too_many}); };
  EXPECT_NE(message_of<InvalidStep>(ask).find("2^31"), std::string::npos);
}

TEST_P(BadInput, CoordinatesThatAreNotFiniteAreNamedByVertex) {
  for (const double bad : {kNan, kInfinity, -kInfinity})
    for (auto* points : {&scene.start, &scene.end}) {
      Detector detector = yardstick::make_detector(scene.mesh(), options);
      const double before = (*points)[7][1];
      (*points)[7][1] = bad;
      EXPECT_NE(message_of<InvalidStep>([&] { (void)detector.contacts(scene.step()); }).find("vertex 7"),
                std::string::npos);
      (*points)[7][1] = before;
      EXPECT_NO_THROW((void)detector.contacts(scene.step())) << "a refused step spoils the detector";
    }
}

// Bug: vertices that nothing uses count for the frame of the boxes, which becomes infinite. Files hold such vertices.
TEST_P(BadInput, VerticesThatNothingUsesMayHoldAnything) {
  const PairSet expected = find_names(scene, options);
  scene.add_vertex({kNan, kInfinity, 0}, {1e300, kNan, -kInfinity}, 0);
  EXPECT_EQ(find_names(scene, options), expected);
}

TEST_P(BadInput, OptionsOutsideTheirRange) {
  const auto refuses = [&](const yardstick::Options& bad) {
    EXPECT_THROW(yardstick::make_detector(scene.mesh(), bad), InvalidOptions);
  };
  yardstick::Options bad = options;
  bad.threads = -1;
  refuses(bad);
  for (const double separation : {-1.0, kNan, kInfinity}) {
    bad = options;
    bad.min_separation = separation;
    refuses(bad);
  }
  bad = options;
  bad.isa = static_cast<Isa>(99);
  EXPECT_NE(message_of<InvalidOptions>([&] { yardstick::make_detector(scene.mesh(), bad); }).find("99"),
            std::string::npos);
  bad = options;
  bad.filter.groups_may_touch = {1, 1};
  refuses(bad);
  bad.filter.groups_may_touch = {1};
  bad.filter.group_of_vertex = {0, 0};
  refuses(bad);
  bad.filter.group_of_vertex.assign(scene.start.size(), 1);
  refuses(bad);
  bad.filter.group_of_vertex.assign(scene.start.size(), -1);
  refuses(bad);
}

// Bug: the groups of components_of, -1 for vertices of no feature, are refused; or radii go to other vertices.
TEST(Groups, AreThoseOfComponents) {
  const Mesh mesh(8, {{1, 2, 3}, {5, 6, 7}});
  const std::vector<Point> points{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                  {9, 9, 9}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const Components objects = components_of(mesh);
  yardstick::Options options;
  options.filter.group_of_vertex = objects.of_vertex;
  options.filter.group_count = objects.count;
  ASSERT_EQ(objects.count, 2);
  for (const auto& [radii, is_free] : {std::pair(0.375, true), std::pair(0.625, false)}) {
    options.radii = {0.5, radii};  // the triangles are 1 apart
    EXPECT_EQ(yardstick::make_detector(mesh, options).is_free({points, points}), is_free);
  }
  options.radii.clear();
  options.filter = PairFilter::no_self_contact(objects.of_vertex);
  EXPECT_TRUE(yardstick::make_detector(mesh, options).is_free({points, points}));
}

// Bug: the number of threads goes to oneTBB unchecked. It crashes if asked for a million, warns on stderr for a
// thousand, and provides neither.
TEST_P(BadInput, NoNumberOfThreadsIsTooLarge) {
  const PairSet expected = find_names(scene, options);
  testing::internal::CaptureStderr();
  for (const int threads : {1000, 1000000, std::numeric_limits<int>::max()}) {
    options.threads = threads;
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    EXPECT_EQ(names_of(detector.contacts(scene.step())), expected);
    EXPECT_GE(detector.statistics().threads, 1);
    EXPECT_LE(detector.statistics().threads, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

INSTANTIATE_TEST_SUITE_P(Methods, BadInput, testing::ValuesIn(kMethods),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

TEST(BadPair, CoordinatesThatAreNotFinite) {
  std::array<Point, 4> good{}, bad{};
  bad[2][0] = kNan;
  EXPECT_THROW((void)vertex_face(bad, good), InvalidStep);
  EXPECT_THROW((void)vertex_face(good, bad), InvalidStep);
  EXPECT_THROW((void)edge_edge(bad, good), InvalidStep);
  EXPECT_THROW((void)edge_edge(good, bad), InvalidStep);
}

// Bug: a NaN or infinity that is refused in some coordinates only. Filters rely on the check of all of them.
TEST(BadPair, EachCoordinateOfEachPoint) {
  const std::array<Point, 4> good{};
  for (const double value : {kNan, kInfinity, -kInfinity})
    for (std::size_t point = 0; point < 4; ++point)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<Point, 4> bad{};
        bad[point][axis] = value;
        EXPECT_THROW((void)vertex_face(bad, good), InvalidStep);
        EXPECT_THROW((void)edge_edge(good, bad), InvalidStep);
      }
}

TEST(BadPair, SeparationOutOfRange) {
  const std::array<Point, 4> points{};
  for (const double separation : {-1.0, kNan, kInfinity}) {
    EXPECT_THROW((void)vertex_face(points, points, {separation}), InvalidOptions);
    EXPECT_THROW((void)edge_edge(points, points, {separation}), InvalidOptions);
  }
}

// Bug: the message refuses -1e-9 as "-0.000000", a number that is allowed.
TEST(BadNumber, IsSaidSoThatItReadsBack) {
  const Scene scene = scenes::scene_by_name("soup", 5, 1);
  Detector detector(scene.mesh());
  const Step step = scene.step();
  const std::array<Point, 4> points{};
  const auto says = [](const auto& action, const std::string& number) {
    EXPECT_NE(message_of<InvalidOptions>(action).find(" is " + number + ": give"), std::string::npos);
  };
  says([&] { (void)detector.contacts(step, {.min_separation = -1e-9}); }, "-1e-09");
  says([&] { Detector(scene.mesh(), {.min_separation = -0.1}); }, "-0.1");
  says([&] { (void)detector.pairs_within(scene.start, -5e-324); }, "-5e-324");
  says([&] { (void)detector.safe_step(step, 1.0000000000000002); }, "1.0000000000000002");
  says([&] { (void)detector.truncate(step, -1e-300); }, "-1e-300");
  says([&] { (void)vertex_face(points, points, {.min_separation = -1e-9}); }, "-1e-09");
  says([&] { (void)edge_edge(points, points, {.latest = 1e300}); }, "1e+300");
}

// Bug: boxes in floats make one point of such a step's start, so that every pair is decided, most in integers.
TEST(AStepThatExplodes, HasItsFirstContactInItsBeginning) {
  for (const char* name : {"folded-cloth", "soup"})
    for (const double far : {1e3, 1e300}) {
      const Scene scene = scenes::scene_by_name(name, 24, 3);
      std::vector<Point> end = scene.start;
      scenes::Random random(5);
      for (Point& p : end)
        for (double& x : p) x += far * random.between(-1, 1);
      for (const double separation : {0.0, 1e-6})
        for (const AtStart at_start : {AtStart::report, AtStart::ignore}) {
          const QueryOptions asked{.min_separation = separation, .at_start = at_start};
          yardstick::Options options;
          options.method = Method::brute;
          const EarliestContact expected =
              yardstick::make_detector(scene.mesh(), options).earliest({scene.start, end}, asked);
          Detector detector(scene.mesh());
          const EarliestContact first = detector.earliest({scene.start, end}, asked);
          ASSERT_TRUE(first.contact && expected.contact) << name << far;
          EXPECT_EQ(first.contact->vertices, expected.contact->vertices) << name << far;
          EXPECT_EQ(first.toi_lower, expected.toi_lower) << name << far;
          EXPECT_EQ(first.toi_upper, expected.toi_upper) << name << far;
          const StageCount asked_of = detector.statistics().stages.front();
          const auto all = static_cast<double>(scene.mesh().edges().size() * scene.mesh().edges().size() / 2);
          EXPECT_LT(static_cast<double>(asked_of.ee), 0.3 * all) << name << far;
        }
    }
}

// Bug: the frame of the boxes held the whole flight, so that in its floats all that flies together was one point.
TEST(AStepThatGoesFarAsAWhole, HasTheContactsOfAllPairsAndLooksAtFew) {
  for (const double far : {1e3, 1e7}) {
    const Scene scene = scenes::scene_by_name("folded-cloth", 400, 3);
    std::vector<Point> end = scene.end;
    for (Point& p : end) p = {p[0] + far, p[1] - 0.5 * far, p[2]};
    for (const double separation : {0.0, 0.01}) {
      const QueryOptions asked{.min_separation = separation};
      yardstick::Options options;
      options.method = Method::brute;
      Detector all = yardstick::make_detector(scene.mesh(), options), detector(scene.mesh());
      const auto expected = names_of(all.contacts({scene.start, end}, asked));
      EXPECT_FALSE(expected.empty());
      EXPECT_EQ(names_of(detector.contacts({scene.start, end}, asked)), expected) << far;
      const StageCount boxes = detector.statistics().stages.front();
      EXPECT_EQ(detector.earliest({scene.start, end}, asked).toi_lower,
                all.earliest({scene.start, end}, asked).toi_lower);
      EXPECT_EQ(detector.safe_step({scene.start, end}, 0.1, asked).toi_lower,
                all.safe_step({scene.start, end}, 0.1, asked).toi_lower);
      Detector near(scene.mesh());
      (void)near.contacts(scene.step(), asked);
      EXPECT_LT(boxes.ee, 2 * near.statistics().stages.front().ee + 100) << far;
    }
  }
}

// Bug: brackets were 1e-11 long at all times. The bracket of a pair that touches just after a beginning of the step
// could begin before that of the first pair in it: so the beginning gave another answer than lists and single pairs.
TEST(AStepThatExplodes, HasTheFirstContactOfAllPairsWhereTwoComeInOneInstant) {
  const std::vector<Point> start{{-0x1.2bbe0bf936f82p-1, -0x1.f79863eb1ae47p-2, -0x1.c5b63f3cafb35p-2},
                                 {-0x1.6c8b439581063p-1, -0x1.7ae147ae147aep-1, -0x1.db22d0e56041ap-4},
                                 {-0x1.47ae147ae147p-7, -0x1.6666666666666p-1, -0x1.5c28f5c28f5c3p-1},
                                 {-0x1.4fdf3b645a1cap-1, -0x1.9999999999998p-4, -0x1.84189374bc6a8p-1},
                                 {0x1.10ff86a32bb8ep-1, 0x1.1b64457b1146ep-1, 0x1.0b92242811562p-1},
                                 {0x1.78d4fdf3b645ap-2, 0x1.0a3d70a3d70a4p-2, 0x1.a5e353f7ced91p-1},
                                 {0x1.a8f5c28f5c28fp-1, 0x1.3333333333333p-2, 0x1.c28f5c28f5c29p-2},
                                 {0x1.a9fbe76c8b43ap-2, 0x1.7ae147ae147aep-1, 0x1.5a1cac083126ep-2},
                                 {-1, -1, -1},
                                 {1, 1, 1}};
  std::vector<Point> end = start;
  end[0] = {0x1.6ff580d0bbce2p+19, -0x1.b3c8339876419p+10, -0x1.1563497236927p+19};
  end[4] = {-0x1.eb84da787042bp+17, -0x1.33330fc6aa83dp+18, -0x1.47adf3089cc2bp+18};
  Detector detector(Mesh(10, {{1, 2, 3}, {5, 6, 7}}, {}, {0, 4, 8, 9}));
  yardstick::Options options;
  options.method = Method::brute;
  const EarliestContact expected = yardstick::make_detector(detector.mesh(), options).earliest({start, end});
  ASSERT_TRUE(expected.contact);
  for (int time = 0; time < 3; ++time) {  // the first answer is that of a beginning, the others are those of lists
    const EarliestContact first = detector.earliest({start, end});
    ASSERT_TRUE(first.contact);
    EXPECT_EQ(first.contact->vertices, expected.contact->vertices) << time;
    EXPECT_EQ(first.toi_lower, expected.toi_lower) << time;
    EXPECT_LT(first.toi_upper - first.toi_lower, 1e-6 * first.toi_upper) << time;
  }
}

TEST(BadName, OfAnInstructionSetNamesTheChoices) {
  EXPECT_NE(message_of<InvalidOptions>([] { (void)isa_from_name("sse9"); }).find("baseline"), std::string::npos);
}

}  // namespace
}  // namespace tamis::test
