// Gathering: which bodies are near enough to be asked about, which of their items are gathered as one mesh, and how
// long this mesh serves later questions.
#pragma once
#include <map>
#include <memory>
#include <optional>
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

/// The gathered mesh holds all items that come within the near distance plus `width`. So it covers later questions
/// while both bodies of each pair together deviate by at most `width` from their motions when it was gathered.
struct GatherMargin {
  double separation, width;
  std::map<BodyId, StraightMotion> motions;

  bool covers(const BodyList& bodies, const std::vector<BodyPair>& pairs) const;
  std::uint64_t memory_bytes() const { return held_bytes(motions); }
};

/// One gathered mesh, of pairs of bodies whose vertices all go straight, of pairs of which one body turns, or of all
/// pairs in a pose.
struct Gathering {
  MotionKind least, most;  ///< of the body that moves more in a pair asked about
  /// Items within this many mean edges of the finest body beyond the needed distance are gathered, too, to serve later
  /// questions; more where a GatherMargin answers those without a search.
  double margin_in_edges;
  std::unique_ptr<Gathered> gathered = nullptr;
  std::size_t needed_when_gathered = 0;               ///< number of items
  std::optional<GatherMargin> margin = std::nullopt;  ///< of bodies that do not turn
  int served = 0, searched = 0;                       ///< questions; those that the margin did not cover

  bool wants(const Body& a, const Body& b) const {
    const MotionKind kind = std::max(a.motion_kind(), b.motion_kind());
    return least <= kind && kind <= most;
  }
  bool serves(const BodyList& bodies, const std::vector<BodyPair>& near, const NearDistance& distance) const {
    return gathered && margin && distance.displacement_factor == 0 && distance.separation <= margin->separation &&
           gathered->keeps_motion_kinds(bodies) && margin->covers(bodies, near);
  }
};

}  // namespace tamis
