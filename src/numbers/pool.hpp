// Scratch memory of the bodies that run at the same time, on whatever threads.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "numbers/held_bytes.hpp"

namespace tamis {

/// Objects to take and to give back. A body that takes one has it for itself, even if its thread runs another body
/// before this one ends. There are never more objects than bodies that ran at once.
template <class T>
class Pool {
 public:
  /// make(i) makes the object number i. Several threads may call it.
  explicit Pool(std::function<std::unique_ptr<T>(std::size_t)> make) : make_(std::move(make)) {}
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// An object that nobody else has until the pointer is gone: this thread's last one, if that is free, which may still
  /// be in the thread's cache.
  auto take() {
    std::unique_lock lock(mutex_);
    const auto give_back = [this](T* object) {
      const std::lock_guard back(mutex_);
      free_.push_back({object, std::this_thread::get_id()});
    };
    using Taken = std::unique_ptr<T, decltype(give_back)>;
    if (free_.empty()) {
      const std::size_t number = count_++;
      lock.unlock();
      std::unique_ptr<T> made = make_(number);
      lock.lock();
      free_.reserve(all_.size() + 1);  // so that giving back never fails
      all_.push_back(std::move(made));
      return Taken(all_.back().get(), give_back);
    }
    const auto own = std::ranges::find(free_, std::this_thread::get_id(), &Free::user);
    std::swap(own == free_.end() ? free_.back() : *own, free_.back());
    T* const object = free_.back().object;
    free_.pop_back();
    return Taken(object, give_back);
  }

  /// All objects, while no body runs.
  std::span<const std::unique_ptr<T>> all() const { return all_; }
  std::uint64_t memory_bytes() const { return held_bytes(all_); }

 private:
  struct Free {
    T* object;
    std::thread::id user;  ///< the thread that had it last
  };

  const std::function<std::unique_ptr<T>(std::size_t)> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> all_;
  std::vector<Free> free_;
  std::size_t count_ = 0;
};

}  // namespace tamis
