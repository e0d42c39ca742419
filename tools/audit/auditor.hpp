// An audit of a motion that is still going on: one frame after the other, as a simulation makes them.
#pragma once
#include <string>

#include "audit/frame_asker.hpp"
#include "audit/new_pairs.hpp"
#include "audit/report.hpp"

namespace tamis::audit {

/// What was found in a frame that was added, and in the step to it.
struct Added {
  FrameAnswer answer;
  std::vector<Finding> pairs;
};

class Auditor {
 public:
  /// All threads ask about the same frame. Throws InvalidOptions.
  Auditor(std::shared_ptr<const AuditedMesh> mesh, Options options);
  Auditor(const Auditor&) = delete;
  Auditor& operator=(const Auditor&) = delete;

  /// Asks about the next frame and keeps it until the one after it. A frame without a name is called by its number.
  /// Frames that cannot be used are reported. Throws Cancelled: the frame is then not part of the report, and may be
  /// added again.
  Added add(std::vector<Point> positions, std::string name);
  /// The report of the frames added so far. Valid until the next frame is added.
  const Report& report() { return builder_.report(); }

 private:
  const Options options_;
  std::shared_ptr<const AuditedMesh> mesh_;
  FrameAsker asker_;
  NewPairs new_pairs_;
  ReportBuilder builder_;
  FramePointer before_;
};

}  // namespace tamis::audit
