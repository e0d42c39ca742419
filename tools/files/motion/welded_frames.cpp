#include "files/motion/welded_frames.hpp"

#include <numeric>

namespace tamis::io {
namespace {

bool has_all(const audit::Frame& frame) {
  return frame.problem.empty() && frame.positions.size() == static_cast<std::size_t>(frame.mesh->mesh().vertex_count());
}

}  // namespace

WeldedFrames::WeldedFrames(std::unique_ptr<audit::FrameSource> source, audit::FrameSource& scout, double distance)
    : source_(std::move(source)) {
  std::shared_ptr<const audit::AuditedMesh> last;
  while (const audit::FramePointer frame = scout.next()) {
    if (!frame->mesh) continue;
    if (frame->mesh != last)
      welds_.emplace_back(static_cast<std::size_t>(frame->mesh->mesh().vertex_count()), distance);
    last = frame->mesh;
    if (has_all(*frame)) welds_.back().add_frame(frame->positions);
  }
}

audit::FramePointer WeldedFrames::next() {
  audit::FramePointer given = source_->next();
  if (!given || !given->mesh) return given;
  if (given->mesh != last_) {
    last_ = given->mesh;
    const Weld& weld = welds_.at(topologies_++);
    welded_ = std::make_shared<audit::AuditedMesh>(weld.welded(last_->mesh()), last_->objects());
  }
  audit::Frame frame = *given;
  frame.mesh = welded_;
  return std::make_shared<const audit::Frame>(std::move(frame));
}

std::size_t WeldedFrames::joined_count() const {
  return std::accumulate(welds_.begin(), welds_.end(), std::size_t{0},
                         [](std::size_t sum, const Weld& weld) { return sum + weld.joined_count(); });
}

}  // namespace tamis::io
