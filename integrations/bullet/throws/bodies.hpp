// Rigid bodies in a Bullet world, as it is or clamped, and what they did there.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "integrations/bullet/throws/arena.hpp"

namespace tamis::bullet {

struct Body {
  std::shared_ptr<btCollisionShape> shape;
  btScalar mass;  ///< 0: it stands
  btTransform place;
  btVector3 velocity{0, 0, 0}, spin{0, 0, 0};
  btVector3 goes{1, 1, 1}, turns{1, 1, 1};  ///< Bullet's linear and angular factors: 0 along an axis where it may not
};

enum class Sleep { as_bullet, never, from_the_start };

struct BodyScene {
  std::vector<Body> bodies;
  btVector3 gravity{0, -10, 0};
  Sleep sleep = Sleep::as_bullet;
};

struct BodyRun {
  std::vector<Triangles> bodies;
  std::vector<btScalar> masses;
  Places places;                                   ///< steps + 1
  std::vector<std::vector<btVector3>> velocities;  ///< as places
  double milliseconds = 0, slowest = 0;            ///< processor time of a step: the mean, and the slowest one's
  double questions = 0;                            ///< that the clamp asks in a step; 0 without it
};

/// Steps of 1/60 s. REQUIRES: steps >= 1, at least one body.
BodyRun run_bodies(const BodyScene& scene, int steps, bool clamped);

/// Bodies that hang: through the last 40 steps they kept their places, and wanted to go faster than 0.2 m/s.
std::vector<std::size_t> hanging(const BodyRun& run);
/// The largest speed that a hanging body has at the end; 0 if none hangs.
double hanging_speed(const BodyRun& run);
/// Pairs of bodies that pass through each other at the end.
std::size_t overlapping(const BodyRun& run);
/// Of all bodies, along x: when the run begins, and when it ends.
std::array<double, 2> momentum(const BodyRun& run);

}  // namespace tamis::bullet
