// Gathering: which bodies are near enough to be asked about, what is gathered of them as one mesh, and how long that
// serves later questions.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "numerics/error_bounds.hpp"
#include "numerics/held_bytes.hpp"
#include "world/gathered.hpp"

namespace tamis {

/// How near bodies must come to be asked about: within the separation, both radii, and a multiple of both
/// displacements.
struct NearDistance {
  double separation = 0;
  double displacement_factor = 0;

  /// What one body adds.
  double share_of(const Body& body) const;
  double between(const Body& a, const Body& b) const { return (separation + share_of(a) + share_of(b)) * kRoundedUp; }
};

/// What was gathered is all that comes within the near distance plus `width`. So it covers later questions while both
/// bodies of each pair together deviate by no more than `width` from the motions that they had then.
struct GatherMargin {
  double separation, width;
  std::map<BodyId, StraightMotion> motions;

  bool covers(const BodyList& bodies, const std::vector<BodyPair>& pairs) const;
  std::uint64_t memory_bytes() const { return held_bytes(motions); }
};

/// One gathered mesh of bodies that meet: of those whose vertices all go straight, of those of which one turns, or of
/// all in a pose.
struct Gathering {
  MotionKind least, most;  ///< of the body of a pair that moves most: such pairs are asked about
  /// Items within so many mean edges of the finest body more than needed are gathered, too, so that they serve the
  /// questions that follow; more where these are answered without a search (GatherMargin).
  double margin_in_edges;
  std::unique_ptr<Gathered> gathered = nullptr;
  std::size_t needed_when_gathered = 0;               ///< items
  std::optional<GatherMargin> margin = std::nullopt;  ///< of bodies that do not turn
  int served = 0, searched = 0;                       ///< questions, and those that the margin did not cover

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
