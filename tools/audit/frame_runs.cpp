#include "audit/frame_runs.hpp"

#include <algorithm>

namespace tamis::audit {
namespace {

/// A detector lists pairs ahead for up to 32 steps, and begins a new list in each run.
constexpr std::size_t kLongestRun = 32;
/// For the positions of one run; memory holds about two runs for each thread.
constexpr std::size_t kRunBytes = std::size_t{16} << 20;

/// The largest number of frames in a run, from the size of one frame.
std::size_t longest_run(const FramePointer& frame) {
  const std::size_t bytes = std::max<std::size_t>(frame->positions.size() * sizeof(Point), 1);
  return std::clamp<std::size_t>(kRunBytes / bytes, 1, kLongestRun);
}

}  // namespace

FrameRuns::FrameRuns(FrameSource& source, int threads) : source_(source) {
  read_up_to(1);
  if (read_.empty()) return;
  const auto count = static_cast<std::size_t>(threads);
  most_ = longest_run(read_.front());
  read_up_to(count * most_);
  // Few frames, or large ones, are asked about one after the other, each by all threads.
  if (read_.size() <= count || most_ == 1) {
    shares_ = {1, threads};
  } else {
    shares_ = {threads, 1};
    if (has_ended_) most_ = (read_.size() + count - 1) / count;
  }
}

FrameRun FrameRuns::next() {
  read_up_to(most_);
  const auto end = read_.begin() + static_cast<std::ptrdiff_t>(std::min(most_, read_.size()));
  FrameRun run{number_, before_, {read_.begin(), end}};
  read_.erase(read_.begin(), end);
  number_ += static_cast<std::int64_t>(run.frames.size());
  if (!run.frames.empty()) before_ = run.frames.back();
  return run;
}

void FrameRuns::read_up_to(std::size_t frames) {
  try {
    while (!has_ended_ && read_.size() < frames) {
      FramePointer frame = source_.next();
      has_ended_ = frame == nullptr;
      if (frame) read_.push_back(std::move(frame));
    }
  } catch (...) {
    error_ = std::current_exception();
    has_ended_ = true;
  }
}

}  // namespace tamis::audit
