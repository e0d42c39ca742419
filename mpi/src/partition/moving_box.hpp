// Boxes of elements, and when two of them may hold features that matter. All in doubles and outward: what is left out
// is proven not to matter.
#pragma once
#include <limits>

#include "mpi/src/partition/element_set.hpp"

namespace tamis::distributed {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Box {
  Point low, high;
};

/// A box at t=0, and one at t=1; for NearWithin one of drifts in its place: of how far vertices go.
struct MovingBox {
  Box start, other;

  /// Holds nothing.
  static MovingBox empty() {
    const Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    return {box, box};
  }
  void include(const MovingBox& box);
};

/// What the boxes of a question are made of.
struct BoxRule {
  double min_separation = 0;
  std::vector<double> radius_of_group;  ///< empty: all zero
  bool has_drifts = false;              ///< in the place of positions at t=1
};

/// One an element, wider by half the separation and the largest radius of its vertices.
std::vector<MovingBox> boxes_of(const ElementSet& set, const BoxRule& rule);

/// May features in two boxes touch, by a time?
struct MeetUntil {
  double time = 1;

  bool operator()(const MovingBox& a, const MovingBox& b) const;
};

/// May a pair of features in two boxes end the step before a time, of which a fraction of their distance is to be kept?
/// Only if it is fast enough: its reserve at t=0 is at most `reach`, time / (1 - keep), times the speed at which
/// its features move against each other (docs/numerics.md, "Step lengths").
struct NearWithin {
  double reach = 1;

  bool operator()(const MovingBox& a, const MovingBox& b) const;
};

}  // namespace tamis::distributed
