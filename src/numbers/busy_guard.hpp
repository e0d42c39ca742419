// One question at a time. A second one is refused at once, before the two can spoil each other's answers.
#pragma once
#include <atomic>

#include "tamis/error.hpp"

namespace tamis {

/// Held while a question is answered. Each detector and each world has one. So may any data that a caller keeps beside
/// them.
class BusyGuard {
 public:
  /// Throws Busy if it is held already: by another thread, or by this thread, which calls from within a question (a
  /// filter, a path).
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
