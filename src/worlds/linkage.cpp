// Makes links of joints, and chains of links.
#include "tamis/linkage.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "curves/motions/chain_motion.hpp"
#include "numbers/finite.hpp"
#include "numbers/floating_point_state.hpp"
#include "numbers/length.hpp"
#include "search/topology/at.hpp"
#include "tamis/error.hpp"
#include "worlds/linkage_tree.hpp"

namespace tamis {
namespace {

bool has_no_rotation(const Pose& pose) { return pose.rotation == Point{0, 0, 0}; }

/// The pose that applies `inner`, then `outer`, in doubles. A part that turns nothing leaves the other's rotation as it
/// is.
Pose composed(const Pose& outer, const Pose& inner) {
  const Point position = transform_at({{outer, outer}}, 0).of(inner.position);
  if (has_no_rotation(inner)) return {position, outer.rotation};
  if (has_no_rotation(outer)) return {position, inner.rotation};
  return {position, pose_at({{outer, outer}, {inner, inner}}, 0).rotation};
}

std::string joint_name(std::size_t number) { return "joint " + std::to_string(number); }

void refuse_bad(const Joint& joint, std::size_t number) {
  const auto refuse = [&](const std::string& why) { throw InvalidOptions(joint_name(number) + why); };
  if (joint.parent < -1 || joint.parent >= static_cast<Index>(number))
    refuse(" has the parent " + std::to_string(joint.parent) + ": give an earlier joint, or -1 for the world");
  if (!is_finite(joint.place) || !is_finite(joint.axis) || !std::isfinite(joint.factor) || !std::isfinite(joint.offset))
    refuse(" has a number that is not finite: give a finite place, axis, factor and offset");
  if (joint.kind == JointKind::fixed) return;
  if (joint.kind != JointKind::turning && joint.kind != JointKind::sliding)
    refuse(" has no such kind: give fixed, turning or sliding");
  if (joint.axis == Point{0, 0, 0}) refuse(" moves along no axis: give a direction other than 0");
  if (joint.coordinate < 0)
    refuse(" moves by the coordinate " + std::to_string(joint.coordinate) +
           ": give the index of its number in a configuration, from 0");
}

/// A direction of length 1. An axis of the frame stays as it is.
Point unit(const Point& axis) {
  const double size = std::max({std::fabs(axis[0]), std::fabs(axis[1]), std::fabs(axis[2])});
  const Point scaled{axis[0] / size, axis[1] / size, axis[2] / size};
  const double length = length_of(scaled[0], scaled[1], scaled[2]);
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

void refuse_uneven(std::size_t starts, std::size_t ends, std::size_t dimension) {
  if (starts != ends || (dimension == 0 ? starts != 0 : starts % dimension != 0))
    throw InvalidOptions("the starts have " + std::to_string(starts) + " numbers, the ends " + std::to_string(ends) +
                         ": give " + std::to_string(dimension) + " for each configuration");
}

}  // namespace

LinkageTree::LinkageTree(const std::vector<Joint>& joints, const std::vector<CarriedBody>& given) {
  // The frame of each joint: its link moves it (-1: none), and this is its constant pose behind the link.
  std::vector<Carried> frames;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    refuse_bad(joint, i);
    const Carried base = joint.parent < 0 ? Carried{-1, {}} : frames[at(joint.parent)];
    const Pose place = composed(base.place, joint.place);
    if (joint.kind == JointKind::fixed) {
      frames.push_back({base.link, place});
      continue;
    }
    const Pose turn{{0, 0, 0}, place.rotation};
    const Point axis = unit(joint.axis);
    links.push_back({base.link, joint.kind, place.position,
                     has_no_rotation(turn) ? axis : transform_at({{turn, turn}}, 0).of(axis), joint.coordinate,
                     joint.factor, joint.offset});
    frames.push_back({static_cast<Index>(links.size()) - 1, turn});
    dimension = std::max(dimension, at(joint.coordinate) + 1);
  }
  for (const CarriedBody& body : given) {
    const std::string name = "body " + std::to_string(body.body) + " of the linkage";
    if (body.joint < 0 || at(body.joint) >= joints.size())
      throw InvalidOptions(name + " is carried by joint " + std::to_string(body.joint) + ", but there are " +
                           std::to_string(joints.size()) +
                           " joints, counted from 0: name one of them (a body that no joint moves is not listed; it "
                           "has its pose from add)");
    if (!is_finite(body.place)) throw InvalidOptions(name + " has a place that is not finite: give a finite pose");
    if (std::ranges::find(bodies, body.body) != bodies.end())
      throw InvalidOptions(name + " is named twice: give each once");
    const Carried& frame = frames[at(body.joint)];
    bodies.push_back(body.body);
    carried.push_back({frame.link, composed(frame.place, body.place)});
  }
}

std::vector<Index> LinkageTree::links_of(const Carried& body) const {
  std::vector<Index> path;
  for (Index link = body.link; link >= 0; link = links[at(link)].parent) path.push_back(link);
  std::ranges::reverse(path);
  return path;
}

RigidChain LinkageTree::chain(const Carried& body, std::span<const double> start, std::span<const double> end) const {
  RigidChain chain;
  for (const Index link : links_of(body)) {
    const Link& moving = links[at(link)];
    chain.push_back({moving.pose(start[at(moving.coordinate)]), moving.pose(end[at(moving.coordinate)])});
  }
  if (!body.is_in_place()) chain.push_back({body.place, body.place});
  return chain;
}

void LinkageTree::add_motions(std::span<const double> start, std::span<const double> end,
                              std::vector<BodyMotion>& motions) const {
  for (const Carried& body : carried) motions.emplace_back(Rigid{chain(body, start, end)});
}

bool LinkageTree::turns_little(std::span<const double> start, std::span<const double> end) const {
  constexpr double kSmall = 100, kFarthest = 0x1p30;  // the limits are 4096 and 2^32 radians; for a hundred links, 2^40
  double turn = 0, farthest = 0;
  for (const Link& link : links) {
    const double from = start[at(link.coordinate)], to = end[at(link.coordinate)];
    turn += std::fabs(link.factor * (to - from));
    farthest =
        std::max({farthest, std::fabs(link.factor * from + link.offset), std::fabs(link.factor * to + link.offset)});
    for (const double x : link.position) farthest = std::max(farthest, std::fabs(x));
  }
  for (const Carried& body : carried)
    for (const double x : body.place.position) farthest = std::max(farthest, std::fabs(x));
  return links.size() < 100 && turn <= kSmall && farthest <= kFarthest;
}

Linkage::Linkage(std::vector<Joint> joints, std::vector<CarriedBody> bodies)
    : tree_(computing([&] { return std::make_shared<const LinkageTree>(joints, bodies); })) {}

std::size_t Linkage::dimension() const { return tree_->dimension; }
const std::vector<BodyId>& Linkage::bodies() const { return tree_->bodies; }

std::vector<BodyMotion> Linkage::motions(std::span<const double> starts, std::span<const double> ends) const {
  const ComputingState state;
  const std::size_t size = dimension();
  refuse_uneven(starts.size(), ends.size(), size);
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < starts.size(); i += size) {
    for (std::size_t k = i; k < i + size; ++k)
      if (!std::isfinite(starts[k]) || !std::isfinite(ends[k]))
        throw InvalidStep("configuration " + std::to_string(i / size) +
                          " holds a number that is not finite: give finite ones");
    tree_->add_motions(starts.subspan(i, size), ends.subspan(i, size), motions);
  }
  return motions;
}

}  // namespace tamis
