// One question at a time: a second one is refused at once, in place of two that spoil each other's answer.
#pragma once
#include <atomic>

#include "tamis/error.hpp"

namespace tamis {

/// Held by whoever asks. Detectors have one; so may what a caller keeps beside a detector.
class Turn {
 public:
  /// Throws Busy if somebody holds it: another thread, or this one, in a function that it calls.
  explicit Turn(std::atomic_flag& is_taken) : is_taken_(is_taken) {
    if (is_taken_.test_and_set(std::memory_order_acquire)) throw Busy();
  }
  ~Turn() { is_taken_.clear(std::memory_order_release); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  std::atomic_flag& is_taken_;
};

}  // namespace tamis
