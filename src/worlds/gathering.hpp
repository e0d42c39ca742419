// Gathering: finds the bodies that are near enough, and gathers their items as one mesh. Tells how long this mesh
// serves later questions.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "worlds/gathered.hpp"

namespace tamis {

/// One gathered mesh. It holds pairs of bodies whose vertices all go straight, or pairs with a body that turns, or
/// pairs that turn together, in their frame. Or it holds all pairs in a pose.
struct Gathering {
  MotionKind least, most;  ///< of the body that moves more in a queried pair
  /// Items within this many mean edges of the finest body beyond the needed distance are gathered, too. So the mesh
  /// serves later questions.
  double margin_in_edges;
  std::unique_ptr<Gathered> gathered = nullptr;
  std::size_t needed_when_gathered = 0;  ///< number of items
  int served = 0, searched = 0;          ///< questions; those that counted no needed items are among `searched`
  int in_vain = 0;                       ///< meshes in a row that served no later question

  bool wants(const Body& a, const Body& b) const {
    const MotionKind kind = std::max(a.motion_kind(), b.motion_kind());
    const bool is_of_frame = least == MotionKind::turning && turn_together(a, b);
    return least <= kind && kind <= most && !is_of_frame;
  }
  /// For bodies that turn. True if meshes have served no later question, as where each question is about other motions.
  /// Then only needed items are gathered; now and then a margin is tried again.
  bool serves_once() const {
    constexpr int kTries = 4, kTriesAgain = 16;
    return least == MotionKind::turning && in_vain >= kTries && in_vain % kTriesAgain != 0;
  }
  std::uint64_t memory_bytes() const { return held_bytes(gathered); }
};

}  // namespace tamis
