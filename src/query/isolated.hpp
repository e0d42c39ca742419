// A callback of the user's, or a whole question, may wait for oneTBB. A waiting thread takes other tasks, among them
// parts of the loop that it is in, which would use this thread's buffers while they are half full. In isolation it
// takes only tasks of what it waits for.
#pragma once
#include <tbb/task_arena.h>

namespace tamis {

/// Runs f(). Whoever waits in it takes only tasks that began in it.
template <class F>
auto isolated(const F& f) {
  return tbb::this_task_arena::isolate(f);
}

}  // namespace tamis
