// Frames from a source, in runs that one thread asks about.
#pragma once
#include <exception>
#include <vector>

#include "audit/frame_source.hpp"
#include "audit/options.hpp"

namespace tamis::audit {

/// Frames that follow each other.
struct FrameRun {
  std::int64_t first;   ///< number of the first frame
  FramePointer before;  ///< the one before it, null for the first of all
  std::vector<FramePointer> frames;
};

/// How an audit is shared among threads.
struct Shares {
  int askers = 1;   ///< detectors that ask about different frames
  int threads = 1;  ///< of each
};

/// Cuts the frames of a source into runs.
class FrameRuns {
 public:
  /// Reads as many frames as keep all threads busy at first. Keeps a reference.
  FrameRuns(FrameSource& source, int threads);

  const Shares& shares() const { return shares_; }
  /// The next run; one without frames if the source has come to its end, or has thrown.
  FrameRun next();
  /// What the source threw, null if it did not.
  const std::exception_ptr& error() const { return error_; }

 private:
  void read_up_to(std::size_t frames);

  FrameSource& source_;
  Shares shares_;
  std::vector<FramePointer> read_;  ///< frames that are in no run yet
  FramePointer before_;
  std::int64_t number_ = 0;
  std::size_t most_ = 1;  ///< frames a run
  bool has_ended_ = false;
  std::exception_ptr error_;
};

}  // namespace tamis::audit
