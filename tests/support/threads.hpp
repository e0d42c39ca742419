// Threads for questions, however many cores there are: oneTBB's, if the library has them, and a pool that is lent.
#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "tamis/options.hpp"
#if defined(TAMIS_HAS_TBB)
#include <tbb/global_control.h>
#endif

namespace tamis::test {

/// Lets questions have so many of oneTBB's threads while it lives.
class AllowedThreads {
#if defined(TAMIS_HAS_TBB)
 public:
  explicit AllowedThreads(int threads)
      : allowed_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}

 private:
  tbb::global_control allowed_;
#else
 public:
  explicit AllowedThreads(int) {}
#endif
};

/// A scheduler as an engine may have: threads that take tasks from one queue. A thread that waits for its loop takes
/// tasks too, also other loops'. So loops may be nested.
class EnginePool {
 public:
  /// `threads` besides the one that calls. Each calls begin() first.
  explicit EnginePool(
      int threads, std::function<void()> begin = [] {}) {
    for (int i = 0; i < threads; ++i)
      threads_.emplace_back([this, begin] {
        begin();
        work();
      });
  }
  ~EnginePool() {
    {
      const std::lock_guard lock(mutex_);
      is_closed_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  EnginePool(const EnginePool&) = delete;
  EnginePool& operator=(const EnginePool&) = delete;

  void parallel_for(int count, const std::function<void(int)>& body) {
    ++loops_;
    std::atomic<int> left = count;
    {
      const std::lock_guard lock(mutex_);
      for (int i = 0; i < count; ++i)
        tasks_.push_back([&, i] {
          body(i);
          --left;
        });
    }
    changed_.notify_all();
    while (left > 0)
      if (!run_one()) std::this_thread::yield();
  }
  ParallelFor lend() {
    return [this](int count, const std::function<void(int)>& body) { parallel_for(count, body); };
  }
  int loops() const { return loops_; }

 private:
  using Task = std::function<void()>;

  bool run_one() {
    std::unique_lock lock(mutex_);
    if (tasks_.empty()) return false;
    const Task task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
    return true;
  }
  void work() {
    for (bool is_closed = false; !is_closed;) {
      if (run_one()) continue;
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return is_closed_ || !tasks_.empty(); });
      is_closed = is_closed_;
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  bool is_closed_ = false;
  std::atomic<int> loops_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace tamis::test
