// Threads. A question runs in an Arena, and its loops on the arena's threads: oneTBB's, an engine's, or the caller's
// alone. Only parallel.cpp knows oneTBB. Every body of a loop computes in a ComputingState for the question's caller.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>

#include "numbers/floating_point_state.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// The number of threads that share a loop here, at least 1.
int threads_here();
/// False if a loop within a body of another one would stay with its thread.
bool loops_nest();

/// parallel_for() of any function.
void run_loop(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);
/// run_isolated() of any function.
void run_isolated(const std::function<void()>& work);

/// Calls f(begin, end) for parts of 0 to `count`, in any order, on the threads of the arena. Parts other than the last
/// have at least half of `grain` items. An exception of f ends the loop. REQUIRES: grain > 0.
template <class F>
void parallel_for(std::size_t count, std::size_t grain, const F& f) {
  run_loop(count, grain, std::cref(f));
}

/// Returns f(). While a thread waits inside oneTBB, in a user's callback or a nested question, it may take other tasks.
/// Among them are parts of the loop that it is in, or of a loop of the caller's. An isolated thread takes only tasks
/// that were started within f().
template <class F>
auto isolated(const F& f) {
  using Result = std::invoke_result_t<const F&>;
  if constexpr (std::is_void_v<Result>) {
    run_isolated(std::cref(f));
  } else {
    std::optional<Result> result;
    run_isolated([&] { result.emplace(f()); });
    return *std::move(result);
  }
}

/// Runs one of the caller's functions, in the caller's floating-point state.
template <class F>
auto of_caller(const F& f) {
  return isolated([&] {
    const CallersState state;
    return f();
  });
}

/// Runs questions with a number of threads.
class Arena {
 public:
  /// `options`: members `threads` and `parallel_for` as in Options.
  explicit Arena(const auto& options) : Arena(options.threads, options.parallel_for) {}
  Arena(int threads, ParallelFor lent);
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Calls work(). If an arena of oneTBB is full, another thread calls it.
  void run(const std::function<void()>& work);

 private:
  struct OwnThreads;
  std::unique_ptr<OwnThreads> own_;  ///< null: the threads of the caller's arena, lent threads, or no others
  const ParallelFor lent_;
  const int threads_;
};

}  // namespace tamis
