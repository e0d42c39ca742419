// Accepts the legal motions of a body, and refuses others with a sentence.
#include <algorithm>
#include <cmath>
#include <string>

#include "numbers/finite.hpp"
#include "numbers/length.hpp"
#include "numbers/number_text.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"
#include "worlds/body.hpp"

namespace tamis {
namespace {

/// The most radians that all links together may turn in a step: one for each piece. On longer pieces chords prove
/// little. Each pair that they leave is cut further by itself (docs/worlds.md, "How far a body may turn").
constexpr double kMostTurn = kMostPieces;
/// The longest rotation vector in radians. Doubles are 2^-20 apart there, and longer vectors mean no angle.
constexpr double kLongestRotation = 0x1p32;

/// With no larger coordinates and no more links, doubles certainly represent a vertex' position.
constexpr double kSafeCoordinate = 0x1p40;
constexpr std::size_t kSafeLinks = 100;

bool is_safe(const Point& x) {
  return std::ranges::all_of(x, [](double c) { return std::fabs(c) <= kSafeCoordinate; });
}
bool is_safe(const RigidChain& chain) {
  return chain.size() <= kSafeLinks && std::ranges::all_of(chain, [](const RigidLink& link) {
           return is_safe(link.start.position) && is_safe(link.end.position);
         });
}

double distance(const Point& a, const Point& b) { return length_of(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// REQUIRES: finite poses.
void refuse_far_turns(const RigidChain& chain, const std::string& name) {
  double turn = 0;
  for (const RigidLink& link : chain) {
    for (const Pose& pose : {link.start, link.end})
      if (const double length = distance(pose.rotation, {}); length > kLongestRotation)
        throw InvalidStep("a rotation vector of " + name + " is " + number_text(length) +
                          " radians long, beyond 2^32: take whole turns off it, as doubles have no finer angles there");
    if (link.start.rotation != link.end.rotation) turn += distance(link.start.rotation, link.end.rotation);
  }
  if (turn > kMostTurn)
    throw InvalidStep(name + " turns by " + number_text(turn) + " radians in one step, beyond " +
                      number_text(kMostTurn) + ": query parts of the step");
}

}  // namespace

RigidChain chain_of(const BodyMotion& motion) {
  if (const auto* still = std::get_if<Static>(&motion)) return {{still->pose, still->pose}};
  if (const auto* rigid = std::get_if<Rigid>(&motion)) return rigid->chain;
  return {};
}

bool Body::is_surely_representable() const {
  return deforming() ? hull_.largest_coordinate() <= kSafeCoordinate
                     : is_safe(chain_of(motion_)) && shape_->radius <= kSafeCoordinate;
}

void Body::validate(const BodyMotion& motion) const {
  const std::string name = "body " + std::to_string(id_);
  const RigidChain chain = chain_of(motion);
  for (const RigidLink& link : chain)
    if (!is_finite(link.start) || !is_finite(link.end))
      throw InvalidStep("a pose of " + name + " is not finite: give finite positions and rotation vectors");
  const auto* deforming = std::get_if<Deforming>(&motion);
  if (!deforming) {
    refuse_far_turns(chain, name);
    if (!is_safe(chain) || shape_->radius > kSafeCoordinate) validate_far(chain);
    return;
  }
  for (const auto& [points, when] : {std::pair(&deforming->start, "start"), std::pair(&deforming->end, "end")}) {
    if (points->size() != shape_->points.size())
      throw InvalidStep(name + " has " + std::to_string(points->size()) + " points at the " + when +
                        " of its motion, its shape " + std::to_string(shape_->points.size()) +
                        " vertices: give one point a vertex");
    for (const Index v : shape_->mesh.points())
      if (!is_finite((*points)[at(v)]))
        throw InvalidStep("vertex " + std::to_string(v) + " of " + name + " at the " + when +
                          " of its motion is not finite: give finite points");
  }
}

void Body::validate_far(const RigidChain& chain) const {
  const std::string name = "body " + std::to_string(id_);
  const ChainBounds bounds(chain);
  for (const auto& [time, when] : {std::pair(0, "start"), std::pair(1, "end")}) {
    const RoundedTransform place = transform_at(chain, time);
    const auto is_known = [&](const Point& x) {  // if no link turns, points go straight from double to double
      return is_finite(place.of(x)) && (!bounds.turns() || std::isfinite(place.error_of(sum_of_sizes(x), 0)));
    };
    for (const Index v : shape_->mesh.points())
      if (!is_known(shape_->points[at(v)]))
        throw InvalidStep("where vertex " + std::to_string(v) + " of " + name + " is at the " + when +
                          " of its motion is beyond what doubles hold: give shorter positions");
  }
  if (bounds.turns() && !std::isfinite(bounds.of(shape_->radius, 0).orbit_radius))
    throw InvalidStep(name + " turns about a point that is farther away than doubles hold: give shorter positions");
}

}  // namespace tamis
