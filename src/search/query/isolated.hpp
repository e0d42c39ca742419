// Task isolation. While a thread waits inside oneTBB, in a user's callback or a nested question, it may take other
// tasks. Among them are parts of the loop that it is in. These would use the thread's half-filled buffers. An isolated
// thread takes only tasks of the callback or question that it waits for.
#pragma once
#include <tbb/task_arena.h>

#include "numbers/floating_point_state.hpp"

namespace tamis {

/// Runs f(). Threads that wait within it take only tasks that were started within it.
template <class F>
auto isolated(const F& f) {
  return tbb::this_task_arena::isolate(f);
}

/// Runs one of the caller's functions, in the caller's floating-point state.
template <class F>
auto of_caller(const F& f) {
  return isolated([&] {
    const CallersState state;
    return f();
  });
}

}  // namespace tamis
