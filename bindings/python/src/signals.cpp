#include "python/src/signals.hpp"

#include "python/src/truth.hpp"

namespace tamis::python {

namespace nb = nanobind;

void Signals::begin() {
  asker_ = std::this_thread::get_id();
  asked_ = Clock::now();
  is_stopped_ = false;
  raised_ = nullptr;
}

bool Signals::ask() {
  if (is_stopped_.load(std::memory_order_relaxed)) return true;
  if (std::this_thread::get_id() != asker_) return false;
  const auto now = Clock::now();
  if (now - asked_ < kPause) return false;
  asked_ = now;
  if (!interpreter_says_stop()) return false;
  is_stopped_ = true;
  return true;
}

bool Signals::interpreter_says_stop() {
  const nb::gil_scoped_acquire lock;
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    return !is_cancelled_.is_none() && truth_of(is_cancelled_(), [] { return "is_cancelled"; });
  } catch (...) {
    raised_ = std::current_exception();
    return true;
  }
}

void Signals::rethrow() {
  if (raised_) std::rethrow_exception(std::exchange(raised_, nullptr));
}

}  // namespace tamis::python
