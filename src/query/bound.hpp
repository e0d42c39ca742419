// What the threads of a query share of its answer, so that they spare each other parts of the search.
#pragma once
#include <atomic>

#include "numerics/assert.hpp"

namespace tamis {

class Bound {
 public:
  /// Begins a query, or one about the part of the step until `latest`.
  void begin(double latest = 1) {
    TAMIS_ASSERT(0 <= latest && latest <= 1);
    latest_.store(latest, std::memory_order_relaxed);
    is_settled_.store(false, std::memory_order_relaxed);
  }
  /// The latest time of interest: nothing later in the step can change the answer.
  double latest() const { return latest_.load(std::memory_order_relaxed); }
  /// Lowers the latest time of interest to `time`, if that is earlier.
  void lower(double time) {
    double latest = this->latest();
    while (time < latest && !latest_.compare_exchange_weak(latest, time, std::memory_order_relaxed)) {
    }
  }
  /// No pair can change the answer any more.
  bool is_settled() const { return is_settled_.load(std::memory_order_relaxed); }
  void settle() { is_settled_.store(true, std::memory_order_relaxed); }

 private:
  std::atomic<double> latest_ = 1;
  std::atomic<bool> is_settled_ = false;
};

}  // namespace tamis
