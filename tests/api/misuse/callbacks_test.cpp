// Filters, cancellation and paths are the caller's own functions: they may ask other detectors, and use oneTBB. Bug: a
// thread waits for work that such a function has started, and meanwhile takes a task of the question that called the
// function, while its own buffers are in use: contacts come twice, others are lost, or it crashes.
#include <gtest/gtest.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <thread>

#include "support/every_question.hpp"
#include "support/test_names.hpp"
#include "support/yardstick/methods.hpp"

namespace tamis::test {

using yardstick::Method;

namespace {

using scenes::Scene;

/// Acts in some calls of a callback, spread over the question.
class NowAndThen {
 public:
  explicit NowAndThen(std::function<void()> act) : act_(std::move(act)) {}
  void called() {
    if (++calls_ % every_ == 0) act_();
  }
  /// Expects as many calls as were counted so far, and acts in about thirty of them.
  void act_often() {
    constexpr int kTimes = 30;
    every_ = std::max(1, calls_ / kTimes);
  }

 private:
  const std::function<void()> act_;
  std::atomic<int> calls_ = 0;
  int every_ = std::numeric_limits<int>::max();
};

/// The answers must be the same whichever thread waits for which. Uses four threads, however many cores there are.
class Callbacks : public testing::Test {
 protected:
  static constexpr int kThreads = 4;

  /// Waits for a task that another thread releases after a while; meanwhile this thread looks for work. Needs no worker
  /// of oneTBB: under the thread sanitizer, version 2021.8 left such a task waiting while all workers slept.
  static void use_tbb() {
    tbb::task_group group;
    tbb::task_handle task = group.defer([] {});
    std::thread another([&task] {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      task = tbb::task_handle();
    });
    group.wait();
    another.join();
  }
  void ask_another() { (void)others_.local().contacts(small_.step()); }
  std::vector<std::function<void()>> acts() {
    return {use_tbb, [this] { ask_another(); }};
  }

  /// `make_options(callback)` makes options with a function that calls `callback`.
  template <class MakeOptions>
  void expect_same_answers(const Mesh& mesh, const std::vector<AnyQuestion>& questions,
                           const MakeOptions& make_options) {
    for (const auto& act : acts())
      for (const AnyQuestion& question : questions) {
        NowAndThen callback(act);
        arena_.execute([&] {
          Detector detector = yardstick::make_detector(mesh, make_options(callback));
          const auto expected = question.ask(detector);
          callback.act_often();
          EXPECT_TRUE(question.ask(detector) == expected) << question.name << ", of a kept detector";
          Detector another = yardstick::make_detector(mesh, make_options(callback));
          EXPECT_TRUE(question.ask(another) == expected) << question.name;
        });
      }
  }

  const tbb::global_control threads_{tbb::global_control::max_allowed_parallelism, 2 * kThreads};
  tbb::task_arena arena_{kThreads};
  const Scene small_ = two_sheets(12);
  tbb::enumerable_thread_specific<Detector> others_{[this] { return Detector(small_.mesh()); }};
};

class CallbacksOfMethod : public Callbacks, public testing::WithParamInterface<Method> {
 protected:
  yardstick::Options options() const {
    yardstick::Options options;
    options.method = GetParam();
    return options;
  }
  const Index cells_ = GetParam() == Method::tamis ? 40 : 6;
  const Scene scene_ = two_sheets(cells_);
  const std::vector<AnyQuestion> questions_ = questions_of(scene_, 0.3 * edge_of_sheets(cells_));
};

TEST_P(CallbacksOfMethod, AFilterMayAskBack) {
  expect_same_answers(scene_.mesh(), questions_, [&](NowAndThen& callback) {
    yardstick::Options filtered = options();
    filtered.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
      callback.called();
      return true;
    };
    return filtered;
  });
}

TEST_P(CallbacksOfMethod, CancellationMayAskBack) {
  expect_same_answers(scene_.mesh(), questions_, [&](NowAndThen& callback) {
    yardstick::Options cancelled = options();
    cancelled.is_cancelled = [&] {
      callback.called();
      return false;
    };
    return cancelled;
  });
}

INSTANTIATE_TEST_SUITE_P(Methods, CallbacksOfMethod, testing::Values(Method::tamis, Method::brute),
                         [](const testing::TestParamInfo<Method>& method) { return test_name(name_of(method.param)); });

/// Calls the callback, then answers as another path does.
struct CallingPath final : Path {
  CallingPath(const Path& asked, NowAndThen& called) : path(asked), callback(called) {}
  Index vertex_count() const override { return path.vertex_count(); }
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override {
    callback.called();
    path.points_at(time, vertices, points, errors);
  }
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override {
    callback.called();
    path.fine_points_at(time, vertices, points);
  }
  void deviations(double from, double to, std::span<const Index> vertices,
                  std::span<double> deviations) const override {
    callback.called();
    path.deviations(from, to, vertices, deviations);
  }
  const Path& path;
  NowAndThen& callback;
};

TEST_F(Callbacks, PathsMayAskBack) {
  const BezierPath path = bent_path(small_);
  const auto plain = questions_of(path, 0.01);
  for (const auto& act : acts())
    for (std::size_t i = 0; i < plain.size(); ++i) {
      NowAndThen callback(act);
      const CallingPath calling(path, callback);
      const AnyQuestion called = questions_of(calling, 0.01)[i];
      arena_.execute([&] {
        Detector detector(small_.mesh());
        const auto expected = plain[i].ask(detector);
        EXPECT_TRUE(called.ask(detector) == expected) << plain[i].name << ", nothing done";
        callback.act_often();
        EXPECT_TRUE(called.ask(detector) == expected) << plain[i].name;
      });
    }
}

// Bug: a thread that waits in a question to its own detector takes another iteration of the caller's loop, and asks
// that detector again.
TEST_F(Callbacks, EachThreadsOwnDetectorServesALoopOfTheCaller) {
  const Scene scene = two_sheets(40);
  Detector alone(scene.mesh());
  const AnyQuestion contacts = questions_of(scene, 0.01)[0];
  const auto expected = contacts.ask(alone);
  tbb::enumerable_thread_specific<Detector> detectors([&] { return Detector(scene.mesh()); });
  std::atomic<int> wrong = 0;
  arena_.execute([&] {
    constexpr int kTimes = 64;
    tbb::parallel_for(
        0, kTimes, [&](int) { wrong += contacts.ask(detectors.local()) != expected; }, tbb::simple_partitioner());
  });
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace tamis::test
