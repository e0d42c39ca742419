// Where bodies are near each other: pairs of features as contacts that a solver can use.
#pragma once
#include <array>
#include <map>
#include <span>
#include <vector>

#include "integrations/bodies.hpp"

namespace tamis::adapters {

/// A place at which two bodies are near each other.
struct NearContact {
  BodyPair bodies;
  std::array<Point, 2> points;
  Point normal;  ///< unit vector from the second to the first

  double distance() const { return dot(minus(points[0], points[1]), normal); }
};

/// Of contacts of two bodies those that say as much as all, in the same order: among contacts with one normal (within
/// about a thousandth), the nearest, and the farthest in each of eight directions along the plane. Two boxes that lie
/// on each other have some sixty pairs of near features, and a support of four corners.
std::vector<NearContact> essential(std::span<const NearContact> contacts);

/// One feature of a near pair: its vertices, with the weights of its nearest point. Keeps references.
struct NearFeature {
  /// Entries of `vertices` below 0 are none.
  NearFeature(const Shape& shape, std::span<const Index> vertices, const std::array<double, 3>& weights);

  const Shape& shape;
  std::span<const Index> vertices;
  std::array<double, 3> weights;
  std::size_t heaviest;  ///< the place of the largest weight
  Point point;           ///< the nearest one, in the frame of the body

  bool is_vertex() const { return weights[heaviest] == 1; }
  /// True if an earlier face already contains the point, so this feature adds nothing.
  bool is_repeated() const;
  /// True if the faces around the point lead away from the direction `outward` (in the body's frame), up to a few
  /// degrees. Otherwise a point beside it is nearer, and `outward` is not a direction in which to push: two edges of
  /// boxes that lie exactly on each other would push sideways, and so would an edge between two coplanar faces.
  bool is_nearest(const Point& outward) const;

 private:
  std::span<const Index> faces() const;  ///< at the heaviest vertex
  const Face& face(Index number) const { return shape.mesh().faces()[static_cast<std::size_t>(number)]; }
  bool lies_on(const Face& face) const;  ///< one of faces()
};

/// Two bodies within a distance of each other.
struct NearBodies {
  double distance;                    ///< also of pairs of features that push sideways
  std::vector<NearContact> contacts;  ///< essential ones, where one body carries the other
};
using Near = std::map<BodyPair, NearBodies>;

/// Bodies that collide and are within `distance` where the world's motions begin.
Near near_bodies(World& world, const Bodies& bodies, double distance);

/// Where the features of a contact are at a time of the world's motions.
NearContact contact_at(const World& world, const Bodies& bodies, const BodyContact& contact, double time);

}  // namespace tamis::adapters
