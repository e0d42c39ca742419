// Frames of an audit that can be looked at afterwards: where the vertices are, and what was found.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "audit/findings.hpp"

namespace tamis::audit {

/// All of them as long as they fit into so much memory. Then free ones leave: of these every second, every fourth and
/// so on is kept, and the first. Once bad frames alone fill the memory, later ones are not kept.
class KeptFrames {
 public:
  explicit KeptFrames(std::size_t most_bytes = 0) : most_bytes_(most_bytes) {}

  void add(FrameFindings&& findings);
  /// In the order of their numbers.
  const std::vector<FrameFindings>& frames() const { return frames_; }

 private:
  /// Keeps every second free frame of those left; false if there is none that could leave.
  bool thin_out();

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::int64_t stride_ = 1;  ///< of the free frames
  std::vector<FrameFindings> frames_;
};

}  // namespace tamis::audit
