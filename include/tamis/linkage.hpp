// Joints that move the bodies of a world: a robot, by the numbers of its configuration.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tamis/world.hpp"

namespace tamis {

struct LinkageTree;

/// How a joint moves what it carries.
enum class JointKind : std::uint8_t {
  fixed,    ///< not at all
  turning,  ///< about its axis, by its value in radians
  sliding,  ///< along its axis, by its value
};

/// A joint. Its frame is the frame of its parent, times `place`, times its motion by its value, as in a URDF. The value
/// is `factor` times a number of the configuration, plus `offset`. Joints with the same coordinate move together.
struct Joint {
  Index parent = -1;                  ///< the joint that carries it, before it in the list; -1: the world
  Pose place = {};                    ///< its frame at the value 0, in the frame of its parent
  JointKind kind = JointKind::fixed;  ///< a fixed joint needs no axis and no coordinate
  Point axis = {0, 0, 1};             ///< in its own frame; the direction alone counts
  Index coordinate = -1;              ///< which number of a configuration moves it
  double factor = 1;                  ///< of that number
  double offset = 0;                  ///< added to the product
};

/// A body that a joint carries.
struct CarriedBody {
  BodyId body = -1;  ///< its number in the world
  Index joint = -1;  ///< its place in the list of joints
  Pose place = {};   ///< its frame in the frame of the joint
};

/// A tree of joints, or several, and the bodies that they carry. A configuration has `dimension` numbers. Between two
/// configurations each number goes linearly, so each body moves by a chain of its joints, on its true curve. To attach
/// an object to a hand, make another linkage that has it, too.
class Linkage {
 public:
  /// Takes the joints, and the bodies in the order of answers.
  /// Throws InvalidOptions if a joint's parent is not before it, if a joint that moves has no axis or no coordinate, if
  /// numbers are not finite, if a body is named twice or a joint of a body does not exist.
  Linkage(std::vector<Joint> joints, std::vector<CarriedBody> bodies);
  /// Copies share one tree. Moving copies: the source keeps it.
  Linkage(const Linkage&) = default;
  /// Shares the copied linkage's tree.
  Linkage& operator=(const Linkage&) = default;

  /// Returns how many numbers a configuration has: one more than the largest coordinate.
  [[nodiscard]] std::size_t dimension() const;
  /// Returns the numbers of the bodies, in the order of `motions`.
  [[nodiscard]] const std::vector<BodyId>& bodies() const;
  /// Computes how the bodies move from configuration to configuration. `starts` and `ends`: one configuration after the
  /// other. A body's chain has a link for each joint that moves it, outermost first, then a constant one. The constant
  /// places are multiplied in doubles, so bodies are off by some 1e-15 of their distances. Bodies of one joint share
  /// its links bit for bit. Returns for each motion one entry for each body, as World::earliest_many takes them. Throws
  /// InvalidOptions unless both have as many numbers, a multiple of `dimension`; InvalidStep on numbers that are not
  /// finite.
  [[nodiscard]] std::vector<BodyMotion> motions(std::span<const double> starts, std::span<const double> ends) const;

 private:
  friend class World;
  std::shared_ptr<const LinkageTree> tree_;
};

}  // namespace tamis
