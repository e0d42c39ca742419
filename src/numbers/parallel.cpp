#include "numbers/parallel.hpp"

#if defined(TAMIS_HAS_TBB)
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "numbers/assert.hpp"

namespace tamis {
namespace {

/// Whose threads share a loop.
struct Crew {
  bool is_alone = false;              ///< no other threads
  const ParallelFor* lent = nullptr;  ///< an engine's; null: oneTBB's, as far as there is oneTBB
  int threads = 1;                    ///< of the engine
};
constexpr Crew kAlone{.is_alone = true};
constinit thread_local Crew crew_here;

/// This thread's crew while it lives.
class HasCrew {
 public:
  explicit HasCrew(const Crew& crew) : before_(std::exchange(crew_here, crew)) {}
  ~HasCrew() { crew_here = before_; }
  HasCrew(const HasCrew&) = delete;
  HasCrew& operator=(const HasCrew&) = delete;

 private:
  const Crew before_;
};

using LoopBody = std::function<void(std::size_t, std::size_t)>;

/// A loop on an engine's threads. Each call of the engine takes parts until none is left. So all parts are done however
/// the engine shares its calls, and even if it skips some.
class LentLoop {
 public:
  LentLoop(std::size_t count, std::size_t grain, const LoopBody& body) : count_(count), grain_(grain), body_(body) {}

  void run(const Crew& crew) {
    const std::size_t parts = (count_ + grain_ - 1) / grain_;
    const auto calls = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(crew.threads), parts));
    try {
      const CallersState state;
      (*crew.lent)(calls, [this](int) { take_parts(); });
    } catch (...) {
      fail();
    }
    take_parts();
    // An engine that threw may not have waited for the calls that it had begun.
    while (working_ > 0) std::this_thread::yield();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  /// Throws nothing: the engine's threads may not know exceptions.
  void take_parts() noexcept {
    ++working_;
    try {
      const HasCrew alone(kAlone);
      const ComputingState state = ComputingState::for_caller(caller_);
      for (std::size_t begin = 0; (begin = next_.fetch_add(grain_)) < count_;)
        body_(begin, std::min(begin + grain_, count_));
    } catch (...) {
      fail();
    }
    --working_;
  }
  /// Ends the loop with the exception that is being handled, unless there was one before.
  void fail() noexcept {
    next_ = count_;
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }

  const std::size_t count_, grain_;
  const LoopBody& body_;
  const FloatingPointState caller_ = callers_state();
  std::atomic<std::size_t> next_ = 0;
  std::atomic<int> working_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

#if defined(TAMIS_HAS_TBB)

namespace {

/// Crews of oneTBB's threads. They have the floating-point state of their arena, from when that was made.
void run_loop_by_tbb(std::size_t count, std::size_t grain, const LoopBody& body) {
  const auto run_part = [&, caller = callers_state()](const tbb::blocked_range<std::size_t>& part) {
    const HasCrew nested{Crew()};
    const ComputingState state = ComputingState::for_caller(caller);
    body(part.begin(), part.end());
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), run_part);
}

int threads_of_tbb() { return tbb::this_task_arena::max_concurrency(); }

/// The most threads to request from oneTBB. Beyond these it warns on stderr, and a million exhausts its memory.
int most_threads() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace

bool has_threads() { return true; }

void run_isolated(const std::function<void()>& work) { tbb::this_task_arena::isolate(work); }

struct Arena::OwnThreads {
  explicit OwnThreads(int threads) : arena(std::min(threads, most_threads())) {}
  void run(const std::function<void()>& work) {
    arena.execute([&, caller = callers_state()] {
      const HasCrew of_arena{Crew()};
      const ComputingState state = ComputingState::for_caller(caller);
      run_isolated(work);
    });
  }
  tbb::task_arena arena;
};

#else

namespace {

void run_loop_by_tbb(std::size_t count, std::size_t, const LoopBody& body) { body(0, count); }
int threads_of_tbb() { return 1; }

}  // namespace

bool has_threads() { return false; }

void run_isolated(const std::function<void()>& work) { work(); }

struct Arena::OwnThreads {
  explicit OwnThreads(int) {}
  void run(const std::function<void()>& work) { work(); }
};

#endif

int threads_here() {
  if (crew_here.is_alone) return 1;
  return crew_here.lent ? crew_here.threads : threads_of_tbb();
}

bool loops_nest() { return !crew_here.is_alone && !crew_here.lent; }

void run_loop(std::size_t count, std::size_t grain, const LoopBody& body) {
  TAMIS_ASSERT(grain > 0);
  if (count == 0) return;
  if (crew_here.is_alone || count <= grain)
    body(0, count);
  else if (crew_here.lent)
    LentLoop(count, grain, body).run(crew_here);
  else
    run_loop_by_tbb(count, grain, body);
}

Arena::Arena(int threads, ParallelFor lent)
    : own_(threads > 1 && !lent ? std::make_unique<OwnThreads>(threads) : nullptr),
      lent_(std::move(lent)),
      threads_(threads) {}
Arena::~Arena() = default;

void Arena::run(const std::function<void()>& work) {
  Crew crew{.is_alone = threads_ == 1};
  if (lent_ && !crew.is_alone) {
    crew.lent = &lent_;
    crew.threads = threads_ > 0 ? threads_ : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }
  const HasCrew has(crew);
  own_ ? own_->run(work) : run_isolated(work);
}

}  // namespace tamis
