// A detector answers one question at a time. Bug: a second question, by another thread or by a function that the first
// one calls, shares its buffers: wrong contacts, or a crash.
#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

#include "support/every_question.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;

class BusyDetector : public testing::Test {
 protected:
  std::vector<AnyQuestion> everything() const {
    auto all = questions_of(scene_, 0.3 * edge_of_sheets(kCells)), more = questions_of(path_, 0.01);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  /// Expects that every question asked meanwhile is refused, and statistics, too.
  void expect_refused(Detector& detector) const {
    for (const AnyQuestion& question : everything()) EXPECT_THROW(question.ask(detector), Busy) << question.name;
    EXPECT_THROW((void)detector.statistics(), Busy);
    EXPECT_EQ(detector.mesh().vertex_count(), scene_.vertex_count()) << "what does not change may be read";
    EXPECT_EQ(detector.options().min_separation, 0);
  }

  static constexpr Index kCells = 10;
  const Scene scene_ = two_sheets(kCells);
  const BezierPath path_ = bent_path(scene_);
};

TEST_F(BusyDetector, AnswersOneThreadAndRefusesTheOthers) {
  constexpr std::size_t kThreads = 4, kTimes = 60;
  auto questions = everything();
  std::erase_if(questions, [](const AnyQuestion& question) { return !question.is_by_value; });
  Detector alone(scene_.mesh()), shared(scene_.mesh());
  std::vector<std::vector<double>> expected;
  for (const AnyQuestion& question : questions) expected.push_back(question.ask(alone));
  std::atomic<int> answered = 0, refused = 0, wrong = 0;
  const auto ask_often = [&](std::size_t first) {
    for (std::size_t i = first; i < first + kTimes; ++i) {
      const std::size_t which = i % questions.size();
      try {
        wrong += questions[which].ask(shared) != expected[which];
        ++answered;
      } catch (const Busy&) {
        ++refused;
      }
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) threads.emplace_back(ask_often, t);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(answered, 0);
  EXPECT_GT(refused, 0);
  for (std::size_t i = 0; i < questions.size(); ++i) EXPECT_TRUE(questions[i].ask(shared) == expected[i]);
}

TEST_F(BusyDetector, RefusesItsOwnFilter) {
  Detector* own = nullptr;
  std::atomic_flag was_asked;
  Options options;
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
    if (own && !was_asked.test_and_set()) expect_refused(*own);
    return true;
  };
  Detector detector(scene_.mesh(), options), plain(scene_.mesh());
  for (const AnyQuestion& question : everything()) {
    own = &detector;
    was_asked.clear();
    EXPECT_TRUE(question.ask(detector) == question.ask(plain)) << question.name;
    own = nullptr;
  }
  EXPECT_TRUE(was_asked.test()) << "by the last question";
}

TEST_F(BusyDetector, EndsTheQuestionOfAFilterThatDoesNotMind) {
  Detector* own = nullptr;
  Options options;
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) { return !own || own->is_free(scene_.step()); };
  Detector detector(scene_.mesh(), options), plain(scene_.mesh());
  const AnyQuestion contacts = everything()[0];
  own = &detector;
  try {
    contacts.ask(detector);
    ADD_FAILURE() << "a question within the question was answered";
  } catch (const Busy& busy) {
    EXPECT_STREQ(busy.what(),
                 "another question is being answered: give each thread a detector, or a world, of its own");
  }
  own = nullptr;
  EXPECT_TRUE(contacts.ask(detector) == contacts.ask(plain)) << "the detector may be asked again";
}

/// A path that asks a question to the detector that reads it.
struct AskingPath final : Path {
  Index vertex_count() const override { return path.vertex_count(); }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    (void)own.is_free(path);
    path.points_at(time, vertices, points, errors);
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    path.deviations(from, to, vertices, deviations);
  }
  AskingPath(Detector& detector, const Path& asked) : own(detector), path(asked) {}
  Detector& own;
  const Path& path;
};

TEST_F(BusyDetector, RefusesItsOwnPath) {
  Detector detector(scene_.mesh());
  EXPECT_THROW((void)detector.contacts(AskingPath(detector, path_)), Busy);
  EXPECT_FALSE(detector.is_free(path_));
}

TEST_F(BusyDetector, RefusesItsOwnCancellation) {
  Detector* own = nullptr;
  std::atomic_flag was_asked;
  Options options;
  options.is_cancelled = [&] {
    if (own && !was_asked.test_and_set()) expect_refused(*own);
    return false;
  };
  Detector detector(scene_.mesh(), options), plain(scene_.mesh());
  own = &detector;
  EXPECT_TRUE(everything()[0].ask(detector) == everything()[0].ask(plain));
  EXPECT_TRUE(was_asked.test());
}

// Bug: a detector that has been moved from answers questions, and reads memory that it no longer has.
TEST_F(BusyDetector, WhatHasBeenMovedFromSaysSo) {
  Detector plain(scene_.mesh()), first(scene_.mesh());
  const AnyQuestion contacts = everything()[0];
  const auto expected = contacts.ask(plain);
  Detector second = std::move(first);
  for (const AnyQuestion& question : everything()) EXPECT_THROW(question.ask(first), Error) << question.name;
  EXPECT_THROW((void)first.mesh(), Error);
  EXPECT_THROW((void)first.options(), Error);
  EXPECT_THROW((void)first.statistics(), Error);
  EXPECT_TRUE(contacts.ask(second) == expected);
  first = Detector(scene_.mesh());
  EXPECT_TRUE(contacts.ask(first) == expected);
}

// Bug: a detector that is moved during a question loses it. The question goes on in the detector it was moved to.
TEST_F(BusyDetector, MayBeMovedByItsOwnFilter) {
  Detector* own = nullptr;
  std::optional<Detector> moved;
  std::atomic_flag was_moved;
  Options options;
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
    if (own && !was_moved.test_and_set()) moved.emplace(std::move(*own));
    return true;
  };
  options.threads = 1;
  Detector detector(scene_.mesh(), options), plain(scene_.mesh());
  const AnyQuestion contacts = everything()[0];
  own = &detector;
  EXPECT_TRUE(contacts.ask(detector) == contacts.ask(plain));
  ASSERT_TRUE(moved);
  EXPECT_TRUE(contacts.ask(*moved) == contacts.ask(plain));
}

template <class AnyDetector>
concept HasLists = requires(AnyDetector&& detector, const Step& step) {
  std::forward<AnyDetector>(detector).contacts(step);
  std::forward<AnyDetector>(detector).pairs_within(step.start, 1);
  std::forward<AnyDetector>(detector).intersections(step.start);
};
// Bug: a temporary detector returns a view of its list. In `for (const Contact& c : Detector(mesh).contacts(step))` the
// detector is destroyed before the loop begins.
static_assert(HasLists<Detector&> && !HasLists<Detector>);

}  // namespace
}  // namespace tamis::test
