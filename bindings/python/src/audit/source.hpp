// Frames that Python gives, one after the other.
#pragma once
#include "audit/frame_source.hpp"
#include "python/src/arrays.hpp"

namespace tamis::python {

/// A mesh that frames share, as Python holds it.
struct SharedMesh {
  std::shared_ptr<const audit::AuditedMesh> mesh;
};

/// Over an iterator whose items are (name, positions, mesh, problem, note); the Python side has checked them.
class IteratorSource final : public audit::FrameSource {
 public:
  explicit IteratorSource(nb::object iterator) : iterator_(std::move(iterator)) {}

  /// Without the interpreter's lock, which it takes.
  audit::FramePointer next() override;

 private:
  nb::object iterator_;
};

}  // namespace tamis::python
