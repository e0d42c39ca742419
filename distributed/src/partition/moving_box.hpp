// Boxes of elements, and tests whether two of them may hold features that matter. Everything is in doubles and rounded
// outward: a pair that a test leaves out is proven not to matter.
#pragma once
#include "distributed/src/partition/element_set.hpp"
#include "search/bounds/box.hpp"

namespace tamis::distributed {

/// A box at t=0 and a box at t=1; for NearWithin the latter is a box of the vertices' displacements. Empty at first.
struct MovingBox {
  Box start, other;

  void include(const MovingBox& box) {
    start.include(box.start);
    other.include(box.other);
  }
};

/// How the boxes of a question are made.
struct BoxRule {
  double min_separation = 0;
  std::vector<double> radius_of_group;  ///< empty: all zero
  bool has_drifts = false;              ///< `other` holds displacements, not positions at t=1
};

/// One box for each element, widened by half the separation and the largest radius of its vertices.
std::vector<MovingBox> boxes_of(const ElementSet& set, const BoxRule& rule);

/// May features in two boxes touch at or before `time`?
struct MeetUntil {
  double time = 1;

  bool operator()(const MovingBox& a, const MovingBox& b) const;
};

/// May a pair of features in two boxes end the step before a time, if it must keep a fraction of its distance? Only if
/// its clearance at t=0 is at most `reach` = time / (1 - keep) times the speed at which its features move against each
/// other (docs/numerics/steps.md, "Step lengths").
struct NearWithin {
  double reach = 1;

  bool operator()(const MovingBox& a, const MovingBox& b) const;
};

}  // namespace tamis::distributed
