#include "paths/chain_motion.hpp"

#include <algorithm>
#include <cmath>

#include "paths/fine_point.hpp"
#include "paths/rigid_transform.hpp"

namespace tamis {
namespace {

/// Angles that rotation::any_angle halves a few times lose as many bits: in doubles only this many radians.
constexpr double kLargestPlainAngle = 4;

bool turns_far(const Chain& chain) {
  const auto is_far = [](const Pose& pose) {
    return std::hypot(pose.rotation[0], pose.rotation[1], pose.rotation[2]) > kLargestPlainAngle;
  };
  return std::any_of(chain.begin(), chain.end(), [&](const Link& l) { return is_far(l.start) || is_far(l.end); });
}

template <class T>
RoundedTransform rounded(const RigidTransform<T>& exact) {
  RoundedTransform rounded{};
  const auto take = [](const Vec3<BasicInterval<T>>& entries, double& error) {
    const auto one = [&](const BasicInterval<T>& entry) {
      const RoundedNumber number = rounded_number(entry);
      error = std::max(error, number.error);
      return number.value;
    };
    return Point{one(entries.x), one(entries.y), one(entries.z)};
  };
  for (std::size_t i = 0; i < 3; ++i) rounded.rows[i] = take(exact.rows[i], rounded.turn_error);
  rounded.shift = take(exact.shift, rounded.shift_error);
  for (const double s : rounded.shift) rounded.shift_size = std::max(rounded.shift_size, std::fabs(s));
  return rounded;
}

}  // namespace

RoundedTransform rounded_transform_of(const Chain& chain, double time) {
  return turns_far(chain) ? rounded(transform_of<DoubleDouble>(chain, time))
                          : rounded(transform_of<double>(chain, time));
}

double Curvature::deviation(const Interval& length) const {
  const double eighth = (Interval(0.125) * length * length).upper;
  return std::min(rounding::above(eighth * acceleration), 2 * reach);
}

ChainBounds::LinkBounds::LinkBounds(const Link& link)
    : turn(change(link.start.rotation, link.end.rotation)),
      way(change(link.start.position, link.end.position)),
      position(farthest(link.start.position, link.end.position)) {}

ChainBounds::ChainBounds(const Chain& chain)
    : links_(chain.begin(), chain.end()),
      turns_(std::ranges::any_of(chain, [](const Link& link) { return link.start.rotation != link.end.rotation; })) {}

/// Bounds of y and its derivatives, y being the point as one link after the other has moved it. With |R'| <= w and
/// |R''| <= w^2 for a rotation vector that changes by w (docs/numerics.md, "Curved motion"):
///   y' = R' x + R x' + p',   y'' = R'' x + 2 R' x' + R x''.
Curvature ChainBounds::of(double at, double way) const {
  Interval place(at), speed(way), acceleration(0);
  double reach = 0;  // the outermost position moves linearly: no chord deviates from it
  for (auto link = links_.rbegin(); link != links_.rend(); ++link) {
    if (link + 1 == links_.rend()) reach = place.upper;
    const Interval& w = link->turn;
    acceleration = w * w * place + Interval(2) * w * speed + acceleration;
    speed = w * place + speed + link->way;
    place = place + link->position;
  }
  return {acceleration.upper, reach};
}

}  // namespace tamis
