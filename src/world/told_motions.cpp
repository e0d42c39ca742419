// What a body may be told of how it moves, and with which sentence it is refused.
#include <algorithm>
#include <cmath>
#include <string>

#include "numerics/finite.hpp"
#include "tamis/error.hpp"
#include "topology/at.hpp"
#include "world/body.hpp"

namespace tamis {
namespace {

bool is_finite_pose(const Pose& pose) { return is_finite(pose.position) && is_finite(pose.rotation); }

/// Of so many links, poses and points that are no larger, doubles can tell where they take a vertex.
constexpr double kSurelyNear = 0x1p40;
constexpr std::size_t kSurelyFew = 100;

double size_of_sum(const Point& x) { return std::fabs(x[0]) + std::fabs(x[1]) + std::fabs(x[2]); }
bool is_surely_near(const Point& x) {
  return std::ranges::all_of(x, [](double c) { return std::fabs(c) <= kSurelyNear; });
}
bool are_surely_near(const Chain& chain) {
  const auto is_near = [](const Pose& pose) { return is_surely_near(pose.position) && is_surely_near(pose.rotation); };
  return chain.size() <= kSurelyFew &&
         std::ranges::all_of(chain, [&](const Link& link) { return is_near(link.start) && is_near(link.end); });
}

}  // namespace

Chain chain_of(const BodyMotion& motion) {
  if (const auto* still = std::get_if<Static>(&motion)) return {{still->pose, still->pose}};
  if (const auto* rigid = std::get_if<Rigid>(&motion)) return rigid->chain;
  return {};
}

bool Body::is_surely_near() const {
  return deforming() ? hull_.size() <= kSurelyNear : are_surely_near(chain_.links()) && shape_->radius <= kSurelyNear;
}

void Body::validate(const BodyMotion& motion) const {
  const std::string name = "body " + std::to_string(id_);
  const Chain chain = chain_of(motion);
  for (const Link& link : chain)
    if (!is_finite_pose(link.start) || !is_finite_pose(link.end))
      throw InvalidStep("a pose of " + name + " is not finite: give finite positions and rotation vectors");
  const auto* deforming = std::get_if<Deforming>(&motion);
  if (!deforming) {
    if (!are_surely_near(chain) || shape_->radius > kSurelyNear) validate_far(chain);
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

void Body::validate_far(const Chain& chain) const {
  const std::string name = "body " + std::to_string(id_);
  const ChainWithStillLinks links(chain);
  const ChainBounds bounds(chain);
  for (const auto& [time, when] : {std::pair(0, "start"), std::pair(1, "end")}) {
    const RoundedTransform place = ChainsAt(time).of(links);
    const auto is_known = [&](const Point& x) {  // what does not turn goes straight from double to double
      return is_finite(place.of(x)) && (!bounds.turns() || std::isfinite(place.error_of(size_of_sum(x), 0)));
    };
    for (const Index v : shape_->mesh.points())
      if (!is_known(shape_->points[at(v)]))
        throw InvalidStep("where vertex " + std::to_string(v) + " of " + name + " is at the " + when +
                          " of its motion is beyond what doubles hold: give shorter positions and rotation vectors");
  }
  if (bounds.turns() && !std::isfinite(bounds.of(shape_->radius, 0).reach))
    throw InvalidStep(name + " turns about what is farther away than doubles hold: give shorter positions");
}

}  // namespace tamis
