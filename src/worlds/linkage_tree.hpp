// The joints of a linkage as links of chains. The constant rotations between joints are taken out of the links: a link
// turns about an axis, or slides along it, as both are in the frame of the world at the zero configuration.
#pragma once
#include "tamis/linkage.hpp"

namespace tamis {

struct LinkageTree {
  /// A joint that moves. Takes x to R(value axis) x + position, or to x + position + value axis.
  struct Link {
    Index parent;  ///< the link that carries it; -1: the world
    JointKind kind;
    Point position, axis;
    Index coordinate;
    double factor, offset;

    Pose pose(double number) const {
      const double value = factor * number + offset;
      const Point way{value * axis[0], value * axis[1], value * axis[2]};
      if (kind == JointKind::turning) return {position, way};
      return {{position[0] + way[0], position[1] + way[1], position[2] + way[2]}, {0, 0, 0}};
    }
  };
  /// A body, at a constant pose behind a link.
  struct Carried {
    Index link;  ///< -1: none moves it
    Pose place;

    bool is_in_place() const { return place.position == Point{0, 0, 0} && place.rotation == Point{0, 0, 0}; }
  };

  /// Throws InvalidOptions.
  LinkageTree(const std::vector<Joint>& joints, const std::vector<CarriedBody>& carried);

  /// The links that move a body, outermost first.
  std::vector<Index> links_of(const Carried& body) const;
  /// The chain of a body between two configurations.
  RigidChain chain(const Carried& body, std::span<const double> start, std::span<const double> end) const;
  /// The motions of all bodies between two configurations.
  void add_motions(std::span<const double> start, std::span<const double> end, std::vector<BodyMotion>& motions) const;

  /// True if the motion surely is one that a world takes. So it need not be made only to be refused.
  bool turns_little(std::span<const double> start, std::span<const double> end) const;

  std::vector<Link> links;  ///< each after its parent
  std::vector<BodyId> bodies;
  std::vector<Carried> carried;  ///< as `bodies`
  std::size_t dimension = 0;
};

}  // namespace tamis
