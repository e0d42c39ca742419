// How bodies are to each other when a step begins.
#include <algorithm>

#include "integrations/clamp.hpp"

namespace tamis::adapters {
namespace {

/// In gaps: bodies that were apart, and are farther apart than this by all pairs of features, are apart: the start of a
/// step differs from the end of the last one by some 1e-15.
constexpr double kToldApart = 1e-6;

bool collide_at(const Bodies& engine, const std::array<BodyId, 2>& bodies, const std::array<Index, 2>& vertices) {
  return engine.collides(pair_of(bodies)) && engine.collides_at(bodies, vertices);
}

}  // namespace

BodyMotion resting(const Pose& pose) { return Rigid{RigidChain{{pose, pose}}}; }

std::set<BodyPair> overlapping(World& world) {
  std::set<BodyPair> pairs;
  for (const BodyIntersection& intersection : world.intersections()) pairs.insert(pair_of(intersection.bodies));
  return pairs;
}

std::set<BodyPair> overlapping(World& world, const Bodies& bodies) {
  std::set<BodyPair> pairs;
  for (const BodyIntersection& place : world.intersections())
    if (collide_at(bodies, place.bodies, {place.edge[0], place.face[0]})) pairs.insert(pair_of(place.bodies));
  return pairs;
}

Beginning beginning(World& world, const Bodies& bodies, const ClampOptions& options, bool are_apart) {
  validate(options);
  Beginning now{{}, near_bodies(world, bodies, 2 * options.gap)};
  const auto is_told = [&](const auto& pair) { return pair.second.distance > kToldApart * options.gap; };
  if (are_apart && std::ranges::all_of(now.near, is_told)) return now;
  now.overlapping = overlapping(world, bodies);
  for (const BodyPair& bodies_of_one : now.overlapping) now.near.erase(bodies_of_one);
  return now;
}

}  // namespace tamis::adapters
