// Asks the detector about one frame after the other.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "audit/collapsed.hpp"
#include "audit/findings.hpp"
#include "audit/options.hpp"
#include "audit/ring_search.hpp"
#include "tamis/detector.hpp"

namespace tamis::audit {

/// Keeps one detector from frame to frame. The answers do not depend on what was asked before.
class FrameAsker {
 public:
  /// Keeps a reference to the options. `threads`: of the detector.
  FrameAsker(const Options& options, int threads, std::function<bool()> is_cancelled);

  /// `before`: the frame before, null for the first. Throws Cancelled.
  FrameFindings ask(const FramePointer& before, const FramePointer& frame, std::int64_t number);

 private:
  Collapsed collapsed_in_frame(const FramePointer& frame) const;
  /// Asks from now on about the mesh without these components. Returns false if nothing is left of it.
  bool use(const std::shared_ptr<const AuditedMesh>& mesh, std::vector<bool> left_out);
  void ask_step(FrameFindings& findings);
  void ask_pose(FrameFindings& findings);
  void list(FrameFindings& findings);
  Finding finding(std::int64_t number, Kind kind, std::span<const Index> first, std::span<const Index> second);

  const Options& options_;
  int threads_;
  std::function<bool()> is_cancelled_;
  std::shared_ptr<const AuditedMesh> mesh_;
  std::vector<bool> left_out_;  ///< components that the detector does not know
  std::optional<Detector> detector_;
  std::optional<RingSearch> rings_;
  bool has_point_face_ = false;  ///< a face that is one vertex
  FramePointer free_frame_;      ///< the last frame that is known to have no intersection
};

/// Why the frame cannot be asked about; empty if it can. Looks at every coordinate.
std::string problem_of(const Frame& frame);

}  // namespace tamis::audit
