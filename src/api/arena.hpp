// The oneTBB arena that runs a question: the caller's, or one with a number of threads of its own.
#pragma once
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "numbers/floating_point_state.hpp"
#include "search/query/isolated.hpp"

namespace tamis {

class Arena {
 public:
  /// `threads`, >= 0: as in Options.
  explicit Arena(int threads) : is_own_(threads > 0) {
    if (is_own_) arena_.initialize(std::min(threads, most_threads()));
  }

  /// If the arena is full, another thread runs the work.
  template <class Work>
  void run(const Work& work) {
    if (is_own_)
      arena_.execute(as_task([&] { isolated(work); }));
    else
      isolated(work);
  }
  /// The arena's number of threads; to be called by the work.
  static int threads_here() { return tbb::this_task_arena::max_concurrency(); }

 private:
  /// The most threads to request from oneTBB. Beyond these it warns on stderr, and a million exhausts its memory.
  static int most_threads() {
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  }

  bool is_own_;  ///< false: the caller's
  tbb::task_arena arena_;
};

}  // namespace tamis
