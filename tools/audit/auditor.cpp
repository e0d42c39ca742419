#include "audit/auditor.hpp"

namespace tamis::audit {

Auditor::Auditor(std::shared_ptr<const AuditedMesh> mesh, Options options)
    : options_((require_sound(options), std::move(options))),
      mesh_(std::move(mesh)),
      asker_(options_, options_.threads, options_.is_cancelled),
      builder_(options_) {}

Added Auditor::add(std::vector<Point> positions, std::string name) {
  const auto number = static_cast<std::int64_t>(builder_.report().frames.size());
  if (name.empty()) name = std::to_string(number);
  FramePointer frame = std::make_shared<const Frame>(Frame{std::move(name), std::move(positions), mesh_});
  FrameFindings found = asker_.ask(before_, frame, number);
  new_pairs_.mark(found);
  Added added{found.answer, found.pairs};
  builder_.add(std::move(found));
  before_ = std::move(frame);
  return added;
}

}  // namespace tamis::audit
