// The state of a thread that decides how results round. Error bounds hold only if results round to nearest and
// subnormal numbers are numbers. Engines and other callers set other states. So every public function that computes
// begins with a ComputingState, and so does each task for another thread (parallel.cpp). Callers' functions run in a
// CallersState.
#pragma once
#include "numbers/platform.hpp"

namespace tamis {

/// To nearest, nothing flushed, no signal.
inline constexpr FloatingPointState kToNearest;

/// Whom this thread computes for: part of the thread's state, as the registers are.
struct ComputesFor {
  bool is_computing = false;
  FloatingPointState caller;  ///< if it computes: the state of the caller
};
inline constinit thread_local ComputesFor computes_for;

/// Results round to nearest while it lives. Afterwards the thread has its state of before, also after an exception.
class ComputingState {
 public:
  /// At a door of the library. A thread that computes already has another caller: the one of the outer door.
  ComputingState() : ComputingState(floating_point_state()) {}
  /// In a task of a thread that computes for this caller.
  static ComputingState for_caller(const FloatingPointState& caller) { return {floating_point_state(), caller}; }
  ~ComputingState() {
    if (floating_point_state() != before_) set_floating_point_state(before_);
    computes_for = outer_;
  }
  ComputingState(const ComputingState&) = delete;
  ComputingState& operator=(const ComputingState&) = delete;

 private:
  /// A thread that computes, but in another state, waits. Meanwhile oneTBB has given it a task of the caller's.
  explicit ComputingState(const FloatingPointState& now)
      : ComputingState(now, computes_for.is_computing && now == kToNearest ? computes_for.caller : now) {}
  ComputingState(const FloatingPointState& now, const FloatingPointState& caller) : before_(now), outer_(computes_for) {
    if (before_ != kToNearest) set_floating_point_state(kToNearest);
    computes_for = {true, caller};
  }

  const FloatingPointState before_;
  const ComputesFor outer_;
};

/// The result of f(), computed in a ComputingState: for the initializers of constructors.
template <class F>
auto computing(const F& f) {
  const ComputingState state;
  return f();
}

/// The state of the caller for whom this thread computes.
inline FloatingPointState callers_state() {
  return computes_for.is_computing ? computes_for.caller : floating_point_state();
}

/// The thread has its caller's state while this lives, for one of the caller's functions.
class CallersState {
 public:
  CallersState() : computes_for_(computes_for) {
    if (!computes_for_.is_computing) return;
    if (computes_for_.caller != kToNearest) set_floating_point_state(computes_for_.caller);
    computes_for = {};
  }
  ~CallersState() {
    if (!computes_for_.is_computing) return;
    if (floating_point_state() != kToNearest) set_floating_point_state(kToNearest);
    computes_for = computes_for_;
  }
  CallersState(const CallersState&) = delete;
  CallersState& operator=(const CallersState&) = delete;

 private:
  const ComputesFor computes_for_;
};

}  // namespace tamis
