#pragma once
#include <ctime>

namespace tamis::test {

/// Processor time of this thread: unlike wall-clock time, other users of the machine do not change it.
inline double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace tamis::test
