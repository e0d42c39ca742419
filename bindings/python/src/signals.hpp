// Ctrl-C, and a caller's own wish to stop, while the library works without the interpreter's lock.
#pragma once
#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tamis/error.hpp"

namespace tamis::python {

/// Asks the interpreter now and then, in the thread that asked the question: only the main thread handles signals.
class Signals {
 public:
  /// `is_cancelled`: a Python callable, or none.
  explicit Signals(nanobind::object is_cancelled = nanobind::none()) : is_cancelled_(std::move(is_cancelled)) {}

  const nanobind::object& is_cancelled() const { return is_cancelled_; }
  void clear() { is_cancelled_ = nanobind::none(); }
  /// Works without the interpreter's lock, for the calling thread's question. If the question ended because of an
  /// exception of Python's or of a wrong answer of `is_cancelled`, that is thrown in place of Cancelled.
  template <class Work>
  void during(const Work& work) {
    begin();
    try {
      const nanobind::gil_scoped_release unlocked;
      work();
    } catch (const Cancelled&) {
      rethrow();
      throw;
    }
  }
  /// Says true once the question should end; for Options::is_cancelled.
  bool ask();
  /// What Python raised, if that is why the question ended. Call with the lock held.
  void rethrow();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kPause{50};  ///< taking the lock costs microseconds

  void begin();
  bool interpreter_says_stop();

  nanobind::object is_cancelled_;
  std::thread::id asker_;
  Clock::time_point asked_;
  std::atomic<bool> is_stopped_ = false;
  std::exception_ptr raised_;
};

}  // namespace tamis::python
