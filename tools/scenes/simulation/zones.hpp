// Impact zones: vertices that must move together, because nothing else keeps them apart (Provot 1997).
#pragma once
#include <span>
#include <vector>

#include "scenes/simulation/obstacle.hpp"
#include "tamis/contact.hpp"

namespace tamis::simulation {

/// Every zone moves by one map, affine and invertible at every time of the step: features that start apart stay
/// apart within it. Zones grow until nothing touches any more.
class Zones {
 public:
  explicit Zones(Index vertices);

  /// The four vertices of each contact, and all they are joined with already, become one zone.
  void join(std::span<const Contact> contacts);
  /// Moves each zone with the obstacle in it, or else as its momentum takes it. Motion i is that of the body i;
  /// `body_of_vertex`: -1 for vertices that belong to none. False, and nothing is moved, if a zone is caught between
  /// bodies that move differently.
  bool move(Particles& particles, const Points& start, const std::vector<Index>& body_of_vertex,
            const std::vector<Eigen::Isometry3d>& motions) const;

  /// Vertices in zones.
  Index size() const { return static_cast<Index>(members_.size()); }

 private:
  Index root(Index vertex) const;

  std::vector<Index> parent_;  ///< -1: in no zone
  std::vector<Index> members_;
};

}  // namespace tamis::simulation
