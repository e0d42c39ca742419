// Options::parallel_for: questions run on an engine's threads. The answers have the same bits however the engine calls
// the loop's bodies, and nobody's scratch memory or floating-point state is spoilt.
#include <gtest/gtest.h>

#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "support/caller_states.hpp"
#include "support/every_question.hpp"
#include "support/threads.hpp"
#include "tamis/error.hpp"
#include "tamis/pair.hpp"
#include "tamis/world.hpp"

namespace tamis::test {
namespace {

using scenes::Scene;
using Body = std::function<void(int)>;

constexpr int kThreads = 3;

Options lent(ParallelFor parallel_for) {
  Options options;
  options.threads = kThreads;
  options.parallel_for = std::move(parallel_for);
  return options;
}

class LentThreads : public testing::Test {
 protected:
  std::vector<AnyQuestion> everything() const { return questions_of(scene_, 0.3 * edge_of_sheets(kCells)); }
  /// Of a new detector and of a kept one.
  void expect_same_answers(const Options& options, const std::string& what) const {
    Detector alone(scene_.mesh(), {.threads = 1}), detector(scene_.mesh(), options);
    for (const AnyQuestion& question : everything()) {
      const auto expected = question.ask(alone);
      EXPECT_EQ(question.ask(detector), expected) << question.name << ", " << what;
      EXPECT_EQ(question.ask(detector), expected) << question.name << ", " << what << ", again";
      EXPECT_EQ(detector.statistics().threads, kThreads);
    }
  }

  static constexpr Index kCells = 40;
  const Scene scene_ = two_sheets(kCells);
};

// Bug: a part that no thread does, an answer that depends on who does it, the state of the engine's threads.
TEST_F(LentThreads, OfAPoolGiveTheSameBits) {
  for (const CallerState& state : {kCallerStates[0], kCallerStates[5]}) {
    std::string engines;
    in_state(state, [&] { engines = state_here(); });
    EnginePool pool(kThreads, [&state] { set(state); });
    expect_same_answers(lent(pool.lend()), state.name);
    EXPECT_GT(pool.loops(), 0) << "nothing was shared: the test tests nothing";
    std::mutex mutex;
    pool.parallel_for(20, [&, caller = std::this_thread::get_id()](int) {
      const std::lock_guard lock(mutex);
      if (std::this_thread::get_id() == caller) return;
      EXPECT_EQ(state_here(), engines) << "the engine has its state again";
    });
  }
}

TEST_F(LentThreads, OfAPoolGiveTheSameBitsOnPaths) {
  const Scene scene = two_sheets(8);
  const BezierPath path = bent_path(scene);
  EnginePool pool(kThreads);
  Detector alone(scene.mesh(), {.threads = 1}), detector(scene.mesh(), lent(pool.lend()));
  for (const AnyQuestion& question : questions_of(path, 0.01))
    EXPECT_EQ(question.ask(detector), question.ask(alone)) << question.name;
  EXPECT_GT(pool.loops(), 0);
}

// Bug: a contact is lost because the engine calls bodies in another way than the library's author thought.
TEST_F(LentThreads, AreUsedAsTheEngineLikes) {
  const std::vector<std::pair<std::string, ParallelFor>> engines{{"backwards, by the caller",
                                                                  [](int count, const Body& body) {
                                                                    while (count-- > 0) body(count);
                                                                  }},
                                                                 {"by one other thread",
                                                                  [](int count, const Body& body) {
                                                                    std::thread([&] {
                                                                      for (int i = 0; i < count; ++i) body(i);
                                                                    }).join();
                                                                  }},
                                                                 {"not at all", [](int, const Body&) {}},
                                                                 {"some twice", [](int count, const Body& body) {
                                                                    for (int i = 0; i <= count; ++i) body(i / 2);
                                                                  }}};
  for (const auto& [name, engine] : engines) expect_same_answers(lent(engine), name);
}

// Bug: loops within loops, which engines without nested loops cannot run; other threads for a question that asked for
// none.
TEST_F(LentThreads, AreNeverAskedForFromWithinABodyNorForOneThread) {
  static thread_local int bodies = 0;
  std::atomic<int> nested = 0, most = 0;
  const ParallelFor engine = [&](int count, const Body& body) {
    nested += bodies > 0;
    most = std::max<int>(most, count);
    for (int i = 0; i < count; ++i) {
      ++bodies;
      body(i);
      --bodies;
    }
  };
  expect_same_answers(lent(engine), "one body at a time");
  EXPECT_EQ(nested, 0);
  EXPECT_EQ(most, kThreads);
  Options alone = lent([](int, const Body&) { ADD_FAILURE() << "threads is 1"; });
  alone.threads = 1;
  Detector detector(scene_.mesh(), alone);
  for (const AnyQuestion& question : everything()) question.ask_only(detector);
}

// Bug: a thread that waits in a nested loop takes another part of the search that it is in, with the same buffers; or
// two loops wait for each other.
TEST_F(LentThreads, FiltersMayAskOtherDetectorsOnThem) {
  EnginePool pool(kThreads);
  const Scene small = two_sheets(12);
  std::atomic<int> calls = 0;
  Options options = lent(pool.lend());
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
    if (++calls % 500 == 0) {
      Detector another(small.mesh(), lent(pool.lend()));
      (void)another.contacts(small.step());
    }
    if (calls % 100 == 0) pool.parallel_for(4, [](int) { std::this_thread::yield(); });
    return true;
  };
  expect_same_answers(options, "filter");
  EXPECT_GT(calls, 1000);
}

TEST_F(LentThreads, QuestionsMayBeAskedInTheEnginesOwnLoop) {
  EnginePool pool(kThreads);
  const AnyQuestion contacts = questions_of(scene_, 0.01)[0];
  Detector alone(scene_.mesh(), {.threads = 1});
  const auto expected = contacts.ask(alone);
  std::atomic<int> wrong = 0;
  pool.parallel_for(12, [&](int) {
    Detector detector(scene_.mesh(), lent(pool.lend()));
    wrong += contacts.ask(detector) != expected;
  });
  EXPECT_EQ(wrong, 0);
}

// Bug: the engine's threads serve a question to which nobody lent them.
TEST_F(LentThreads, ServeNoQuestionWithinTheirQuestion) {
  const AllowedThreads allowed(kThreads);
  const Scene small = two_sheets(12);
  std::atomic<int> asked = 0;
  Options options = lent([](int count, const Body& body) {
    while (count-- > 0) body(count);
  });
  options.is_cancelled = [&] {
    if (asked++ >= 20) return false;
    Detector another(small.mesh(), {.threads = 2});
    (void)another.contacts(small.step());
    EXPECT_EQ(another.statistics().threads, has_threads() ? 2 : 1);
    return false;
  };
  Detector detector(scene_.mesh(), options);
  (void)detector.contacts(scene_.step());
  EXPECT_GT(asked, 0);
}

// Bug: an exception passes through the engine, or ends the program, or is lost; the detector is spoilt.
TEST_F(LentThreads, HandExceptionsToTheCaller) {
  EnginePool pool(kThreads);
  std::atomic<bool> fails = true;
  Options options = lent(pool.lend());
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
    return fails ? throw std::runtime_error("filter") : true;
  };
  Detector detector(scene_.mesh(), options), alone(scene_.mesh(), {.threads = 1});
  const AnyQuestion contacts = questions_of(scene_, 0.01)[0];
  EXPECT_THROW(contacts.ask_only(detector), std::runtime_error);
  fails = false;
  EXPECT_EQ(contacts.ask(detector), contacts.ask(alone));
  bool has_threads_now = false;
  Detector another(scene_.mesh(), lent([&](int count, const Body& body) {
                     if (!has_threads_now) throw std::runtime_error("no thread");
                     pool.parallel_for(count, body);
                   }));
  EXPECT_THROW(contacts.ask_only(another), std::runtime_error);
  has_threads_now = true;
  EXPECT_EQ(contacts.ask(another), contacts.ask(alone));
}

TEST_F(LentThreads, CanBeCancelledAndAreBusyMeanwhile) {
  EnginePool pool(kThreads);
  std::atomic<bool> is_cancelled = true;
  std::atomic<int> busy = 0;
  Detector* self = nullptr;
  Options options = lent(pool.lend());
  options.is_cancelled = [&] { return is_cancelled.load(); };
  options.filter.accepts = [&](PairKind, const std::array<Index, 4>&) {
    try {
      (void)self->is_free(scene_.step());
    } catch (const Busy&) {
      ++busy;
    }
    return true;
  };
  Detector detector(scene_.mesh(), options);
  self = &detector;
  EXPECT_THROW((void)detector.contacts(scene_.step()), Cancelled);
  is_cancelled = false;
  EXPECT_FALSE(detector.contacts(scene_.step()).empty());
  EXPECT_GT(busy, 0);
}

// Bug: one of the three takes the option and has no use for it.
TEST_F(LentThreads, ServeListsOfPairsAndWorlds) {
  EnginePool pool(kThreads);
  const std::vector<FeaturePair> pairs(40'000, {PairKind::vertex_face, {3, 0, 1, 2}});
  const std::vector<Point> start{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.25, .25, 1}},
      end{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.25, .25, -1}};
  for (const PairResult& result : narrow_phase(pairs, {start, end}, {.threads = kThreads, .parallel_for = pool.lend()}))
    ASSERT_TRUE(result.touches && result.toi_lower <= 0.5 && 0.5 <= result.toi_upper);
  EXPECT_GT(pool.loops(), 0);

  const auto first_contacts = [&](const Options& options) {
    World world(options);
    const Shape triangle(Mesh(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    world.add(triangle, Static{});
    const BodyId falling = world.add(triangle, Rigid{{{}}});
    std::vector<BodyMotion> motions;
    for (int i = 0; i < 50; ++i) {
      RigidLink link;
      link.start.position = {0.1, 0.1, 1};
      link.end.position = {0.1, 0.1, -1 - 0.1 * i};
      motions.emplace_back(Rigid{{link}});
    }
    std::vector<double> times;
    for (const EarliestBodyContact& first : world.earliest_many(std::vector{falling}, motions))
      times.push_back(first.toi_lower);
    return times;
  };
  const int before = pool.loops();
  EXPECT_EQ(first_contacts(lent(pool.lend())), first_contacts({.threads = 1}));
  EXPECT_GT(pool.loops(), before);
}

// `threads` of a question without lent threads, as documented: without oneTBB it has the caller's alone, and says so.
TEST_F(LentThreads, OthersAreThoseOfOneTbb) {
  const AllowedThreads allowed(kThreads);
  Detector detector(scene_.mesh(), {.threads = kThreads});
  (void)detector.contacts(scene_.step());
  EXPECT_EQ(detector.statistics().threads, has_threads() ? kThreads : 1);
}

}  // namespace
}  // namespace tamis::test
