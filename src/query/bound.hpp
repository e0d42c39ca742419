// What all threads know of the answer to a query, and what spares them the rest of the search.
#pragma once
#include <atomic>

#include "numerics/assert.hpp"

namespace tamis {

class Bound {
 public:
  /// Of a new query, or of one about a part of the step.
  void begin(double latest = 1) {
    TAMIS_ASSERT(0 <= latest && latest <= 1);
    latest_.store(latest, std::memory_order_relaxed);
    is_settled_.store(false, std::memory_order_relaxed);
  }
  /// Nothing later in the step can change the answer.
  double latest() const { return latest_.load(std::memory_order_relaxed); }
  /// A later time than the latest one changes nothing.
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
