// One question at a time: a second one is refused at once, in place of two that spoil each other's answer.
#pragma once
#include <atomic>

#include "tamis/error.hpp"

namespace tamis {

/// Held by whoever asks. Detectors have one; so may what a caller keeps beside a detector.
class BusyGuard {
 public:
  /// Throws Busy if somebody holds it: another thread, or this one, in a function that it calls.
  explicit BusyGuard(std::atomic_flag& is_taken) : is_taken_(is_taken) {
    if (is_taken_.test_and_set(std::memory_order_acquire)) throw Busy();
  }
  ~BusyGuard() { is_taken_.clear(std::memory_order_release); }
  BusyGuard(const BusyGuard&) = delete;
  BusyGuard& operator=(const BusyGuard&) = delete;

 private:
  std::atomic_flag& is_taken_;
};

}  // namespace tamis
