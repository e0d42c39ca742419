// Gathering: which bodies are near enough to be asked about, which of their items are gathered as one mesh, and how
// long this mesh serves later questions.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "worlds/gathered.hpp"

namespace tamis {

/// One gathered mesh, of pairs of bodies whose vertices all go straight, of pairs of which one body turns and that do
/// not turn together, of pairs that turn together in their frame, or of all pairs in a pose.
struct Gathering {
  MotionKind least, most;  ///< of the body that moves more in a pair asked about
  /// Items within this many mean edges of the finest body beyond the needed distance are gathered, too, to serve later
  /// questions; more where these need no search.
  double margin_in_edges;
  std::unique_ptr<Gathered> gathered = nullptr;
  std::size_t needed_when_gathered = 0;  ///< number of items
  int served = 0, searched = 0;          ///< questions; those that needed a search
  int in_vain = 0;                       ///< meshes in a row that served no later question
  NearDistance distance = {};            ///< the mesh holds all items that came within it
  /// Those of the bodies then near each other; none if one of them turned.
  std::map<BodyId, BodyMotion> motions = {};

  bool wants(const Body& a, const Body& b) const {
    const MotionKind kind = std::max(a.motion_kind(), b.motion_kind());
    const bool is_of_frame = least == MotionKind::turning && turn_together(a, b);
    return least <= kind && kind <= most && !is_of_frame;
  }
  /// Of bodies that turn: have meshes served no later question, as where each question is about other motions? Then
  /// only needed items are gathered; now and then a margin is tried again.
  bool serves_once() const {
    constexpr int kTries = 4, kTriesAgain = 16;
    return least == MotionKind::turning && in_vain >= kTries && in_vain % kTriesAgain != 0;
  }
  /// Does the mesh hold all items that come within the distance `now`? It does while both bodies of each pair together
  /// deviate by at most the margin from `motions`, less what `now` is larger.
  bool serves(const BodyList& bodies, const std::vector<BodyPair>& near, const NearDistance& now) const;
  std::uint64_t memory_bytes() const;
};

}  // namespace tamis
