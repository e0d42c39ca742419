// The frames of a recorded motion, one after the other.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "audit/audited_mesh.hpp"
#include "tamis/positions.hpp"

namespace tamis::audit {

/// One frame. Whoever has asked for it may keep it.
struct Frame {
  std::string name;
  /// One a vertex of the mesh.
  std::vector<Point> positions;
  /// The same object as in the frame before if the topology is the same; if it is another object, no step leads here.
  std::shared_ptr<const AuditedMesh> mesh;
  /// Why the frame cannot be used, as a sentence; it then needs no positions and no mesh.
  std::string problem = {};
  /// What a reader should know, as a sentence: for example, that frames are missing before this one.
  std::string note = {};
  /// Is this the end of a step from the frame before?
  bool follows = true;
};

using FramePointer = std::shared_ptr<const Frame>;

/// Asked from one thread alone, the one that called audit().
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// The next frame; null after the last. Any exception ends the audit.
  virtual FramePointer next() = 0;
  /// The number of frames if it is known in advance, else 0.
  virtual std::size_t count() const { return 0; }
};

}  // namespace tamis::audit
