// A motion whose vertices are joined where they lie at one place in every frame.
#pragma once
#include <vector>

#include "audit/frame_source.hpp"
#include "files/mesh/weld.hpp"

namespace tamis::io {

class WeldedFrames final : public audit::FrameSource {
 public:
  /// Reads `scout` to its end: another reader of the frames of `source`. Frames that cannot be used do not count.
  WeldedFrames(std::unique_ptr<audit::FrameSource> source, audit::FrameSource& scout, double distance);

  audit::FramePointer next() override;
  std::size_t count() const override { return source_->count(); }
  /// Of all topologies together.
  std::size_t joined_count() const;

 private:
  std::unique_ptr<audit::FrameSource> source_;
  std::vector<Weld> welds_;                         ///< one a topology, in the order in which they come
  std::size_t topologies_ = 0;                      ///< that have come from `source`
  std::shared_ptr<const audit::AuditedMesh> last_;  ///< of `source`
  std::shared_ptr<const audit::AuditedMesh> welded_;
};

}  // namespace tamis::io
