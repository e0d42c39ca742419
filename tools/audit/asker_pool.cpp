#include "audit/asker_pool.hpp"

#include <chrono>

namespace tamis::audit {
namespace {

/// The longest wait in take(), after which the pool's owner checks whether to stop.
constexpr std::chrono::milliseconds kPause{20};

}  // namespace

AskerPool::AskerPool(const Options& options, const Shares& shares)
    : options_(options), detector_threads_(shares.threads) {
  for (int i = 0; i < shares.askers; ++i) workers_.emplace_back([this] { work(); });
}

AskerPool::~AskerPool() {
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  changed_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void AskerPool::add(FrameRun run) {
  ++held_;
  order_.push_back(run.first);
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(run));
  }
  changed_.notify_all();
}

std::optional<RunFindings> AskerPool::take() {
  std::unique_lock lock(mutex_);
  const auto is_there = [this] { return answered_.count(order_.front()) > 0; };
  if (!changed_.wait_for(lock, kPause, is_there)) return std::nullopt;
  RunFindings found = std::move(answered_.extract(order_.front()).mapped());
  order_.pop_front();
  --held_;
  return found;
}

void AskerPool::work() {
  FrameAsker asker(options_, detector_threads_, [this] { return should_stop(); });
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return is_stopped_ || !waiting_.empty(); });
    if (is_stopped_) return;
    const FrameRun run = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    RunFindings found = ask(asker, run);
    lock.lock();
    answered_.emplace(run.first, std::move(found));
    changed_.notify_all();
  }
}

RunFindings AskerPool::ask(FrameAsker& asker, const FrameRun& run) const {
  RunFindings found;
  try {
    FramePointer before = run.before;
    for (const FramePointer& frame : run.frames) {
      found.frames.push_back(asker.ask(before, frame, run.first + static_cast<std::int64_t>(found.frames.size())));
      before = frame;
    }
  } catch (...) {
    found.error = std::current_exception();
  }
  return found;
}

bool AskerPool::should_stop() const { return is_stopped_ || (options_.is_cancelled && options_.is_cancelled()); }

}  // namespace tamis::audit
