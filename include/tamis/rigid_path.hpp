// Ready-made paths of rigid bodies: turning, moving, and chains of such motions.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "tamis/path.hpp"

namespace tamis {

/// x goes to R x + position, R being the rotation by |rotation| radians about the direction of `rotation`.
struct Pose {
  Point position{0, 0, 0};  ///< where the body's origin is
  Point rotation{0, 0, 0};  ///< rotation vector
};

/// Converts a rotation matrix, given by its rows, as engines keep it, also in floats. It is a rotation with rounding
/// errors: the nearest rotation is taken. The rotation vector is rounded to doubles. So points are off by less than
/// 1e-15 of their distance from the origin of the body.
/// Returns the pose.
/// Throws InvalidPath if it is off by more than rounding: an entry of R R^T - I beyond 1e-4; a reflection; numbers that
/// are not finite.
[[nodiscard]] Pose pose_of_matrix(const std::array<Point, 3>& rows, const Point& position);
/// Converts a quaternion w x y z in the same way.
/// Returns the pose.
/// Throws InvalidPath if |q|^2 - 1 is beyond 1e-4, and on numbers that are not finite.
[[nodiscard]] Pose pose_of_quaternion(const std::array<double, 4>& quaternion, const Point& position);

/// A pose whose position and rotation vector go linearly from `start` (t=0) to `end` (t=1). Any angle.
struct RigidLink {
  Pose start = {};  ///< pose at t=0
  Pose end = {};    ///< pose at t=1
};

/// Outermost link first: a point of the body goes through the last link first. Empty: the body stays where its points
/// are given.
using RigidChain = std::vector<RigidLink>;

/// Makes a chain of one link. Rotation vector and position are linear in t, from one pose to the other.
/// Returns the chain.
[[nodiscard]] RigidChain interpolated_chain(const Pose& start, const Pose& end);
/// Makes a chain that turns from `start` at constant speed about the fixed axis of `turn`, by |turn| radians. Meanwhile
/// one point of the body, `center` in its frame, goes straight to `end_position`. Engines take the center of mass. Any
/// angle: 2 pi is a full turn. With a center other than the origin, places are off by some 1e-15 of the center's
/// distance from the body's origin, and of the body's distance from the world's origin.
/// Returns a chain of two links.
[[nodiscard]] RigidChain turned_chain(const Pose& start, const Point& turn, const Point& end_position,
                                      const Point& center = {0, 0, 0});
/// Makes a chain from one pose to the other by the shorter turn about a fixed axis, at constant speed (slerp).
/// Meanwhile `center` goes straight. The turn is computed in doubles. So the end is reached within some 1e-15 of the
/// body's size.
/// Returns a chain of two links.
[[nodiscard]] RigidChain chain_between(const Pose& start, const Pose& end, const Point& center = {0, 0, 0});
/// Computes the pose of a chain's body at `time`, for example after a step that is safe until then.
/// Returns for one link its pose, linear in time. For more links a pose that turns by at most pi, off by some 1e-15.
/// Throws InvalidPath on numbers that are not finite, and on a time outside [0,1].
[[nodiscard]] Pose pose_at(const RigidChain& chain, double time);
/// Bounds the deviation of engines that blend quaternions and normalize them (nlerp). They go the way of
/// `chain_between` at another speed. A motion that is free by `chain_between`, with this deviation as additional
/// separation, is free by nlerp.
/// Returns a factor. No point is ever farther from its place by `chain_between` than the factor times the point's
/// distance from the center.
/// Throws InvalidPath on numbers that are not finite.
[[nodiscard]] double nlerp_deviation(const Pose& start, const Pose& end);

/// Bodies that each move on a chain of links. A vertex may at the same time go straight in its body's frame. Positions
/// use rotations rounded to doubles, with a proven error. Where that is too coarse, interval arithmetic in doubles or
/// double-double encloses them. Sine and cosine come from their alternating series. Deviations: |x''| (to - from)^2 / 8
/// (docs/numerics/curves.md, "Curved motion").
class RigidPath final : public Path {
 public:
  /// Takes bodies and their chains. `rest`: each vertex in its body's own frame. `body_of_vertex`: one a vertex, in [0,
  /// chains.size()). `rest_end`: where each vertex is in its body's frame at t=1; empty if all stay.
  /// Throws InvalidPath on sizes that do not fit and on numbers that are not finite.
  RigidPath(std::vector<Point> rest, std::vector<Index> body_of_vertex, std::vector<RigidChain> chains,
            std::vector<Point> rest_end = {});
  /// Copies share one motion. Moving copies: the source keeps it.
  RigidPath(const RigidPath&) = default;
  /// Shares the copied path's motion.
  RigidPath& operator=(const RigidPath&) = default;

  /// Returns the number of vertices.
  Index vertex_count() const override;
  /// Write as Path: positions, the same more precisely, and deviations.
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override;
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override;
  void deviations(double from, double to, std::span<const Index> vertices, std::span<double> deviations) const override;
  /// Finds the axis of each vertex' body. There is an axis if the rotation vectors of its chain, from the outermost
  /// link to the last one that changes, are exactly parallel.
  /// Writes the axes, or zeros.
  void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const override;
  /// Finds the frame of the last link that the vertices' bodies share. Links are shared as long as their numbers are
  /// equal, from the outermost one on.
  /// Returns the vertices' motion in it, also if no vertex moves.
  std::optional<CarriedPath> carried(std::span<const Index> vertices) const override;

 private:
  struct Motion;

  std::shared_ptr<const Motion> motion_;
};

}  // namespace tamis
