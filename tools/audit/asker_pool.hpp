// Threads that ask about runs of frames; the answers come back in the order of the frames.
#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "audit/frame_asker.hpp"
#include "audit/frame_runs.hpp"

namespace tamis::audit {

/// The findings in the frames of a run; if `error` is set, in those before it was thrown.
struct RunFindings {
  std::vector<FrameFindings> frames;
  std::exception_ptr error;
};

class AskerPool {
 public:
  /// Keeps a reference to the options.
  AskerPool(const Options& options, const Shares& shares);
  /// Cancels questions that are still asked.
  ~AskerPool();
  AskerPool(const AskerPool&) = delete;
  AskerPool& operator=(const AskerPool&) = delete;

  /// Is there room for one more run? As many runs may wait as there are threads.
  bool has_room() const { return held_ < 2 * workers_.size(); }
  bool is_idle() const { return held_ == 0; }
  void add(FrameRun run);
  /// The answers to the next run; none if they have not come within a short time.
  std::optional<RunFindings> take();

 private:
  void work();
  RunFindings ask(FrameAsker& asker, const FrameRun& run) const;
  bool should_stop() const;

  const Options& options_;
  int detector_threads_;
  std::atomic<bool> is_stopped_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<FrameRun> waiting_;
  std::map<std::int64_t, RunFindings> answered_;  ///< by the number of the first frame
  std::size_t held_ = 0;              ///< runs that were added and not taken; used by the owner's thread alone
  std::deque<std::int64_t> order_;    ///< first frames of these runs; used by the owner's thread alone
  std::vector<std::thread> workers_;  ///< the last member: they use the others
};

}  // namespace tamis::audit
