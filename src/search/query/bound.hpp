// The part of an answer that the threads of a query share, to spare each other parts of the search.
#pragma once
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "numbers/assert.hpp"

namespace tamis {

/// The smallest float at or after a time of the step.
inline float float_after(double t) {
  const auto f = static_cast<float>(t);
  return static_cast<double>(f) >= t ? f : std::nextafter(f, std::numeric_limits<float>::infinity());
}

class Bound {
 public:
  /// The latest time of interest of an answer that the query does not want.
  static constexpr double kNever = -1;

  Bound() { begin(); }

  /// Begins a query, or one about the part of the step until `latest`. `answers`: as Query::answers().
  void begin(double latest = 1, std::size_t answers = 1) {
    TAMIS_ASSERT(0 <= latest && latest <= 1);
    if (answers != latest_.size()) latest_ = std::vector<std::atomic<double>>(answers);
    for (std::atomic<double>& of_answer : latest_) of_answer.store(latest, std::memory_order_relaxed);
    is_settled_.store(false, std::memory_order_relaxed);
  }
  /// The latest time of interest: nothing later in the step can change any answer.
  double latest() const {
    double latest = kNever;
    for (const std::atomic<double>& of_answer : latest_)
      latest = std::max(latest, of_answer.load(std::memory_order_relaxed));
    return latest;
  }
  /// The latest time at which a contact can change this answer.
  double latest(std::size_t answer) const {
    return answer < latest_.size() ? latest_[answer].load(std::memory_order_relaxed) : kNever;
  }
  /// Lowers the latest time of interest of an answer to `time`, if that is earlier. REQUIRES: an answer of the query.
  void lower(double time, std::size_t answer = 0) {
    TAMIS_ASSERT(answer < latest_.size());
    double latest = this->latest(answer);
    while (time < latest && !latest_[answer].compare_exchange_weak(latest, time, std::memory_order_relaxed)) {
    }
  }
  /// No pair can change the answer any more.
  bool is_settled() const { return is_settled_.load(std::memory_order_relaxed); }
  void settle() { is_settled_.store(true, std::memory_order_relaxed); }

 private:
  std::vector<std::atomic<double>> latest_;  ///< of each answer
  std::atomic<bool> is_settled_ = false;
};

}  // namespace tamis
