// What an engine says about its bodies, and about the step that it wants to make.
#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "integrations/vectors.hpp"
#include "tamis/world.hpp"

namespace tamis::adapters {

/// Two bodies, the smaller first.
using BodyPair = std::array<BodyId, 2>;
inline BodyPair pair_of(const std::array<BodyId, 2>& bodies) {
  return {std::min(bodies[0], bodies[1]), std::max(bodies[0], bodies[1])};
}

/// How a body answers impulses. All zero: it does not.
struct Inertia {
  Point inverse_mass{};      ///< along each axis of the world
  Matrix inverse_inertia{};  ///< in the world's axes
};

/// In the unit of the positions, and radians, a second.
struct Velocity {
  Point linear{};  ///< of the origin of the body's poses
  Point angular{};
  bool operator==(const Velocity&) const = default;
};

/// The bodies of an engine.
class Bodies {
 public:
  virtual ~Bodies() = default;

  virtual const Shape& shape(BodyId body) const = 0;
  /// Does the engine collide these two bodies?
  virtual bool collides(const BodyPair& bodies) const = 0;
  /// Does the engine collide two bodies, for which `collides` is true, at these features? For bodies of several parts
  /// that collide with different things. `vertices`: for each body a vertex of its feature.
  virtual bool collides_at(const std::array<BodyId, 2>& /*bodies*/, const std::array<Index, 2>& /*vertices*/) const {
    return true;
  }
};

/// A step that an engine wants to make, after its solver. The proof is about each body's way from pose(body, 0) to its
/// final pose: the origin goes straight, and the body turns the shorter way about a fixed axis (`chain_between`). The
/// origin must be the centre of mass.
class WantedStep : public Bodies {
 public:
  virtual double seconds() const = 0;
  /// In gaps, in (0, 1]: the distance that bodies keep from those that they lie on. Less than one where the engine's
  /// solver lets bodies come to rest a little nearer than a gap: otherwise both would move them to and fro.
  virtual double carried_at() const { return 1; }
  /// Bodies that are to move and may be held back, each once. All others stay where World::move has put them.
  virtual std::span<const BodyId> moving() const = 0;
  /// The pose of a body after `fraction` of its way, in [0, 1], rounded as the engine will keep it: so the proof is
  /// about what the engine does. At 0, also of bodies that stay, where the body is now; at 1 it has turned by less than
  /// half a turn.
  virtual Pose pose(BodyId body, double fraction) const = 0;
  /// The largest distance of a body's points from its origin, or a bound of it; for all bodies.
  virtual double radius(BodyId body) const = 0;
  virtual Inertia inertia(BodyId body) const = 0;
  /// The coefficient of friction between two bodies.
  virtual double friction(const BodyPair& bodies) const = 0;
  /// With which the body begins its next step; also of bodies that stay, such as a platform that is yet to move.
  virtual Velocity velocity(BodyId body) const = 0;
  /// With which a body of moving() goes its way in this step. It may differ from `velocity` where an engine corrects
  /// positions.
  virtual Velocity way(BodyId body) const = 0;
  /// From now on the body wants to go a whole step with this velocity instead, and `pose` is about that way.
  virtual void set_way(BodyId body, const Velocity& way) = 0;
};

}  // namespace tamis::adapters
