#pragma once
#include <ctime>
#include <stdexcept>

namespace tamis::test {

/// Throws on a system without that clock, as WebAssembly: a clock that stands still passes every bound.
inline double seconds_by(clockid_t clock) {
  timespec time{};
  if (clock_gettime(clock, &time) != 0) throw std::runtime_error("this system has no clock of processor time");
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time of this thread: unlike wall-clock time, other users of the machine do not change it.
inline double thread_seconds() { return seconds_by(CLOCK_THREAD_CPUTIME_ID); }

}  // namespace tamis::test
