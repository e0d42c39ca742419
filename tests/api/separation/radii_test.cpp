// Radii, and a question's own separation: the distance that counts as contact differs from pair to pair and from
// question to question, with one hierarchy. Compares with the oracle, which decides each pair's distance exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/kernels_here.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "support/yardstick/pairs.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {
namespace {

using scenes::Recipe, scenes::Scene;

/// Options with three groups that cut through the scene's objects, so that features have vertices of several groups.
yardstick::Options thick(const Scene& scene, const std::vector<double>& radii, Method method) {
  yardstick::Options options;
  options.method = method;
  options.radii = radii;
  options.filter.group_count = 3;
  for (Index v = 0; v < scene.vertex_count(); ++v) options.filter.group_of_vertex.push_back((v / 7) % 3);
  return options;
}

/// Computed without the library: the largest radius of each feature's vertices, plus `fixed`.
double separation_of(const yardstick::Options& options, double fixed, PairKind kind, const PairVertices& v) {
  const auto radius = [&](std::size_t i) {
    if (v[i] < 0) return 0.0;  // loose features have fewer vertices
    return options.radii[static_cast<std::size_t>(options.filter.group_of_vertex[static_cast<std::size_t>(v[i])])];
  };
  if (kind != PairKind::edge_edge) return radius(0) + std::max({radius(1), radius(2), radius(3)}) + fixed;
  return std::max(radius(0), radius(1)) + std::max(radius(2), radius(3)) + fixed;
}

class Thickness : public testing::TestWithParam<Recipe> {};

// Bugs: boxes or lanes with the radius of another vertex, of one feature only, or none; a method that ignores radii.
TEST_P(Thickness, EveryMethodFindsThePairsWithinBothRadii) {
  const Scene scene = GetParam().make(20, 3);
  const double size = size_at_start(scene), fixed = 0.01 * size;
  const std::vector<double> radii{0, 0.02 * size, 0.2 * size};
  const yardstick::Options brute = thick(scene, radii, Method::brute);
  PairSet truth;
  const PairFilter some = some_pairs(scene, 300);
  yardstick::for_each_pair(scene.mesh(), some, [&](PairKind kind, const PairVertices& v) {
    if (oracle::comes_within(kind, motion_of(scene, v), separation_of(brute, fixed, kind, v))) truth.insert({kind, v});
  });
  for (const Method method : kMethods) {
    SCOPED_TRACE(scene.name + " by " + std::string(name_of(method)));
    yardstick::Options options = thick(scene, radii, method);
    options.filter.accepts = some.accepts;
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    const auto contacts = copied(detector.contacts(scene.step(), {.min_separation = fixed}));
    EXPECT_EQ(missing(truth, names_of(contacts)), "") << "missed";
    EXPECT_EQ(missing(names_of(contacts), truth), "") << "a contact, but farther apart";
    EXPECT_EQ(detector.is_free(scene.step(), {.min_separation = fixed}), contacts.empty());
    double lower = 1;
    for (const Contact& c : contacts) lower = std::min(lower, c.toi_lower);
    EXPECT_NEAR(detector.earliest(scene.step(), {.min_separation = fixed}).toi_lower, lower, 1e-9);
  }
}

// Bug: step lengths use another separation than contacts.
TEST_P(Thickness, StepLengthsOfAllMethodsAreTheSameBits) {
  Scene scene = GetParam().make(40, 8);
  for (std::size_t v = 0; v < scene.end.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      scene.end[v][k] = scene.start[v][k] + (scene.end[v][k] - scene.start[v][k]) / 64;
  const double size = size_at_start(scene);
  const std::vector<double> radii{0x1p-11 * size, 0, 0x1p-9 * size};
  for (const double fraction : {0.0, 0.3}) {
    const auto keep = [&](Method method) {
      return yardstick::make_detector(scene.mesh(), thick(scene, radii, method))
          .safe_step(scene.step(), fraction, {.min_separation = 0x1p-14 * size});
    };
    const SafeStep truth = keep(Method::brute);
    EXPECT_EQ(keep(Method::tamis).toi_lower, truth.toi_lower) << scene.name;
    EXPECT_EQ(keep(Method::tamis).pair.has_value(), truth.pair.has_value());
  }
}

// Bug: a question's own separation is kept for the next question, or the tree's boxes do not grow and shrink with it.
TEST_P(Thickness, AQuestionsOwnSeparationAnswersAsADetectorsDoes) {
  const Scene scene = GetParam().make(60, 4);
  const double size = size_at_start(scene);
  for (const Method method : kMethods) {
    yardstick::Options options;
    options.method = method;
    Detector one = yardstick::make_detector(scene.mesh(), options);
    for (const double separation : {0.1 * size, 0.0, 0.003 * size}) {
      options.min_separation = separation;
      Detector own = yardstick::make_detector(scene.mesh(), options);
      const auto& asked = one.contacts(scene.step(), {.min_separation = separation});
      const auto& expected = own.contacts(scene.step());
      ASSERT_EQ(asked.size(), expected.size()) << separation << " " << name_of(method);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        EXPECT_EQ(asked[i].vertices, expected[i].vertices);
        EXPECT_EQ(asked[i].toi_lower, expected[i].toi_lower);
        EXPECT_EQ(asked[i].toi_upper, expected[i].toi_upper);
      }
      EXPECT_EQ(one.is_free(scene.step(), {.min_separation = separation}), expected.empty());
      EXPECT_EQ(one.earliest(scene.step(), {.min_separation = separation}).toi_lower,
                own.earliest(scene.step()).toi_lower);
      EXPECT_EQ(one.safe_step(scene.step(), 0.5, {.min_separation = separation}).toi_lower,
                own.safe_step(scene.step(), 0.5).toi_lower);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Thickness, testing::ValuesIn(scenes::recipes().begin(), scenes::recipes().end()),
                         scene_test_name);

// Bug: lanes of one instruction set load other radii than those of another.
TEST(ThicknessInLanes, EveryInstructionSetGivesTheSameContacts) {
  const Scene scene = scenes::scene_by_name("folded-cloth", 1500, 6);
  const double size = size_at_start(scene);
  yardstick::Options options = thick(scene, {0.001 * size, 0, 0.004 * size}, Method::tamis);
  options.isa = Isa::baseline;
  const auto expected = find_contacts(scene, options);
  EXPECT_GT(expected.size(), 100u);
  for (const Isa isa : every_isa()) {
    options.isa = isa;
    try {
      const auto found = find_contacts(scene, options);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].vertices, expected[i].vertices);
        EXPECT_EQ(found[i].toi_upper, expected[i].toi_upper);
      }
    } catch (const InvalidOptions&) {  // this machine lacks the instruction set
    }
  }
}

TEST(ThicknessThatDoesNotFit, IsRefusedByName) {
  const Scene scene = scenes::scene_by_name("soup", 5, 1);
  const auto message_of = [&](const std::vector<double>& radii) -> std::string {
    try {
      yardstick::make_detector(scene.mesh(), thick(scene, radii, Method::tamis));
    } catch (const InvalidOptions& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  EXPECT_NE(message_of({0, 1}).find("2 entries for 3 groups"), std::string::npos) << message_of({0, 1});
  EXPECT_NE(message_of({0, -1, 0}).find("group 1"), std::string::npos) << message_of({0, -1, 0});
  EXPECT_NE(message_of({0, 0, NAN}).find("group 2"), std::string::npos) << message_of({0, 0, NAN});
  Detector detector(scene.mesh());
  for (const double bad : {-1.0, double(NAN), double(INFINITY)}) {
    EXPECT_THROW((void)detector.contacts(scene.step(), {.min_separation = bad}), InvalidOptions);
    EXPECT_THROW((void)detector.earliest(scene.step(), {.min_separation = bad}), InvalidOptions);
    EXPECT_THROW((void)detector.is_free(scene.step(), {.min_separation = bad}), InvalidOptions);
    EXPECT_THROW((void)detector.safe_step(scene.step(), 0.5, {.min_separation = bad}), InvalidOptions);
  }
}

// Bug: the sum of radii and separation was infinite, and went to exact algebra, whose integers have no infinity.
TEST(Radii, AndSeparationTogetherAreFinite) {
  const Mesh mesh(6, {{0, 1, 2}, {3, 4, 5}});
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  std::vector<Point> end = start;
  end[3][2] = 0.5;
  const Step step{start, end};
  const BezierPath path({start, end, start});
  const auto ask = [&](double radius, double separation) {
    Detector detector(mesh, {.radii = {radius}});
    const QueryOptions how{.min_separation = separation};
    const std::function<void()> questions[] = {[&] { (void)detector.contacts(step, how); },
                                               [&] { (void)detector.earliest(step, how); },
                                               [&] { (void)detector.is_free(step, how); },
                                               [&] { (void)detector.safe_step(step, 0.1, how); },
                                               [&] { (void)detector.truncate(step, 0.1, how); },
                                               [&] { (void)detector.pairs_within(start, separation); },
                                               [&] { (void)detector.contacts(path, {.min_separation = separation}); }};
    int refused = 0;
    for (const auto& question : questions) try {
        question();
      } catch (const InvalidOptions& error) {
        EXPECT_NE(std::string(error.what()).find("together"), std::string::npos) << error.what();
        ++refused;
      }
    return refused;
  };
  EXPECT_EQ(ask(8e307, 1e307), 0);
  EXPECT_EQ(ask(8e307, 8e307), 7);
  EXPECT_EQ(ask(1.7e308, 0), 7);
}

}  // namespace
}  // namespace tamis::test
