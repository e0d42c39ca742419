// Gathering: which bodies are near enough to be asked about, which of their items are gathered as one mesh, and how
// long this mesh serves later questions.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "numerics/error_bounds.hpp"
#include "numerics/held_bytes.hpp"
#include "world/gathered.hpp"

namespace tamis {

/// The distance within which bodies are asked about: the separation, plus both radii, plus a multiple of both
/// displacements.
struct NearDistance {
  double separation = 0;
  double displacement_factor = 0;

  /// What one body adds to the distance.
  double share_of(const Body& body) const;
  double between(const Body& a, const Body& b) const { return (separation + share_of(a) + share_of(b)) * kRoundedUp; }
};

/// One gathered mesh, of pairs of bodies whose vertices all go straight, of pairs of which one body turns, or of all
/// pairs in a pose.
struct Gathering {
  MotionKind least, most;  ///< of the body that moves more in a pair asked about
  /// Items within this many mean edges of the finest body beyond the needed distance are gathered, too, to serve later
  /// questions; more where these need no search.
  double margin_in_edges;
  std::unique_ptr<Gathered> gathered = nullptr;
  std::size_t needed_when_gathered = 0;  ///< number of items
  int served = 0, searched = 0;          ///< questions; those that needed a search
  /// The mesh holds all items that come within `separation`, both radii and `margin` by these motions of the bodies
  /// then near each other; none if one of them turns.
  std::map<BodyId, BodyMotion> motions = {};
  double separation = 0, margin = 0;

  bool wants(const Body& a, const Body& b) const {
    const MotionKind kind = std::max(a.motion_kind(), b.motion_kind());
    return least <= kind && kind <= most;
  }
  /// Does the mesh hold all items needed now? It does while both bodies of each pair together deviate by at most
  /// `margin` from `motions`.
  bool serves(const BodyList& bodies, const std::vector<BodyPair>& near, const NearDistance& distance) const;
  std::uint64_t memory_bytes() const;
};

}  // namespace tamis
