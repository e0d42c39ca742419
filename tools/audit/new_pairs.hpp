// Which pairs of a frame the frame before did not have.
#pragma once
#include <memory>
#include <vector>

#include "audit/findings.hpp"

namespace tamis::audit {

/// Compares each usable frame with the one before it. A pair is new if the frame before, with the step to it, has no
/// pair of the same kind and vertices. Of the first frame no pair is new; after a change of topology every pair is.
/// Where no step leads to the frame before, contacts at the start of the step are not new: they are of that frame.
class NewPairs {
 public:
  /// Sets `is_new` of the pairs, and `fresh`. Frames come in their order. Ignores a frame that was not asked about.
  void mark(FrameFindings& findings);

 private:
  struct Key {
    Kind kind;
    std::array<Index, 5> vertices;
    auto operator<=>(const Key&) const = default;
  };

  bool is_new(const Finding& pair) const;

  std::shared_ptr<const AuditedMesh> mesh_;  ///< of the frame before; null before the first
  bool had_step_ = false;
  std::vector<Key> before_;  ///< sorted
};

}  // namespace tamis::audit
