// Frames of an audit that can be looked at afterwards: where the vertices are, and what was found.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "audit/findings.hpp"

namespace tamis::audit {

/// Keeps all frames while they fit into `most_bytes`. Then it drops free ones: it keeps every second, then every fourth
/// and so on, and the first. Once frames that are not free fill the memory alone, no later frames are kept.
class KeptFrames {
 public:
  explicit KeptFrames(std::size_t most_bytes = 0) : most_bytes_(most_bytes) {}

  void add(FrameFindings&& findings);
  /// In the order of their numbers.
  const std::vector<FrameFindings>& frames() const { return frames_; }

 private:
  /// Drops every second of the kept free frames; false if there is none to drop.
  bool thin_out();

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::int64_t stride_ = 1;  ///< between the numbers of kept free frames
  std::vector<FrameFindings> frames_;
};

}  // namespace tamis::audit
