// A cancelled question ends with Cancelled. Bug: it leaves pairs in a buffer, which turn up in the next answer.
#include <gtest/gtest.h>

#include <atomic>

#include "scenes/scene_list.hpp"
#include "support/contact_sets.hpp"
#include "support/copied.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

constexpr int kNever = -1;

class Cancellation : public testing::TestWithParam<Method> {
 protected:
  Cancellation() {
    options.method = GetParam();
    options.threads = 1;  // so that each question calls is_cancelled as often as the last one
    options.is_cancelled = [this] { return asked++ == cancel_at; };
  }

  /// Expects the contacts and times that a detector finds which was never cancelled.
  void expect_whole_answer(Detector& detector) {
    yardstick::Options plain;
    plain.method = GetParam();
    Detector other = yardstick::make_detector(scene.mesh(), plain);
    const auto& expected = other.contacts(scene.step());
    cancel_at = kNever;
    const auto& contacts = detector.contacts(scene.step());
    ASSERT_EQ(contacts.size(), expected.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_EQ(contacts[i].vertices, expected[i].vertices);
      EXPECT_EQ(contacts[i].toi_lower, expected[i].toi_lower);
    }
  }

  Scene scene = scenes::scene_by_name("soup", GetParam() == Method::brute ? 20 : 400, 3);
  yardstick::Options options;
  std::atomic<int> asked = 0;
  std::atomic<int> cancel_at = kNever;
};

TEST_P(Cancellation, EndsEveryQuestionAndTheNextOneIsAnsweredInFull) {
  Detector detector = yardstick::make_detector(scene.mesh(), options);
  const auto cancelled = [&](const auto& question) {
    asked = 0;
    cancel_at = 1;  // then some pairs are decided, and others wait in buffers
    EXPECT_THROW(question(), Cancelled);
    expect_whole_answer(detector);
  };
  cancelled([&] { (void)detector.contacts(scene.step()); });
  cancelled([&] { (void)detector.earliest(scene.step()); });
  cancelled([&] { (void)detector.safe_step(scene.step(), 0.5); });
}

TEST_P(Cancellation, AtAnyMomentLeavesTheDetectorUsable) {
  asked = 0;
  EXPECT_FALSE(contacts_of(yardstick::make_detector(scene.mesh(), options), scene.step()).empty());
  const int moments = asked;
  ASSERT_GT(moments, 2) << "too few to stop in the middle";
  for (int moment = 0; moment < moments; moment += 1 + moments / 8) {
    // A new detector: a kept one may have listed pairs, and calls is_cancelled less often.
    Detector detector = yardstick::make_detector(scene.mesh(), options);
    asked = 0;
    cancel_at = moment;
    EXPECT_THROW((void)detector.contacts(scene.step()), Cancelled);
    expect_whole_answer(detector);
  }
}

/// Points at rest over a triangle. If the separation is `height`, doubles cannot decide them.
Scene points_over_a_face(Index rows, double height) {
  Scene over;
  for (const Point& p : {Point{-1, -1, 0}, Point{16, -1, 0}, Point{-1, 16, 0}}) over.add_vertex(p, p, 0);
  over.faces.push_back({0, 1, 2});
  for (Index i = 0; i < rows * rows; ++i) {
    const Point p{0.5 * static_cast<double>(i % rows), 0.5 * static_cast<double>(i / rows), height};
    over.loose_points.push_back(over.add_vertex(p, p, 1));
  }
  return over;
}

// Bug: is_cancelled is called only between buffers of thousands of pairs; in integers, one pair may take milliseconds.
TEST_P(Cancellation, ComesBetweenPairsThatAreDecidedOneByOne) {
  options.min_separation = 0.125;
  const Scene over = points_over_a_face(11, 0.125);
  Detector detector = yardstick::make_detector(over.mesh(), options);
  EXPECT_EQ(detector.contacts(over.step()).size(), 121u);
  EXPECT_GE(asked, 100);
}

TEST_P(Cancellation, ThatNeverHappensChangesNothing) {
  Detector detector = yardstick::make_detector(scene.mesh(), options);
  expect_whole_answer(detector);
  EXPECT_GT(asked, 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, Cancellation, testing::Values(Method::tamis, Method::brute),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

}  // namespace
}  // namespace tamis::test
