// Ready-made paths of rigid bodies: turning, moving, and chains of such motions.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "tamis/path.hpp"

namespace tamis {

/// x goes to R x + position, R being the rotation by |rotation| radians about the direction of `rotation`.
struct Pose {
  Point position{0, 0, 0};
  Point rotation{0, 0, 0};
};

/// Of a rotation matrix, given by its rows, or a quaternion w x y z, as engines keep them, also in floats: what
/// rounding has made of a rotation becomes the nearest one. Throws InvalidPath where that is more than rounding: an
/// entry of R R^T - I, or |q|^2 - 1, beyond 1e-4; a reflection; numbers that are not finite. The rotation vector is
/// rounded to doubles: points are off by less than 1e-15 of their distance from the origin of the body.
Pose pose_of_matrix(const std::array<Point, 3>& rows, const Point& position);
Pose pose_of_quaternion(const std::array<double, 4>& quaternion, const Point& position);

/// A pose whose position and rotation vector go linearly from `start` (t=0) to `end` (t=1). Any angle.
struct Link {
  Pose start = {};
  Pose end = {};
};

/// Outermost first: a point of the body goes through the last link first. Empty: at rest where it is given.
using Chain = std::vector<Link>;

/// Rotation vector and position linear in t, from one pose to the other.
Chain interpolated(const Pose& start, const Pose& end);
/// From `start`, turned at constant speed about the fixed axis of `turn` by |turn| radians, while one point of the
/// body, `center` in its frame, goes straight to `end_position`: engines take the center of mass. Any angle: 2 pi is a
/// full turn. With a center, places are off by some 1e-15 of how far it is from the body's origin, and that from the
/// world's.
Chain turned(const Pose& start, const Point& turn, const Point& end_position, const Point& center = {0, 0, 0});
/// From one pose to the other by the shorter turn about a fixed axis, at constant speed (slerp), while `center` goes
/// straight. The turn is computed in doubles: the end is reached within some 1e-15 of the body's size.
Chain between(const Pose& start, const Pose& end, const Point& center = {0, 0, 0});
/// Where a chain takes its body at `time`, as after a step of which that part is safe. Of one link as it goes, of more
/// by a turn of at most pi, off by some 1e-15. Throws InvalidPath on numbers that are not finite, and on a time outside
/// [0,1].
Pose pose_at(const Chain& chain, double time);
/// Engines that blend quaternions and normalize them (nlerp) go the way of `between` at another speed: no point is ever
/// farther from where `between` has it than this, times its distance from the center. What is free by `between` with as
/// much separation is free by theirs. Throws InvalidPath on numbers that are not finite.
double nlerp_deviation(const Pose& start, const Pose& end);

/// Bodies that move each on a chain of links; a vertex may go straight in its body's frame meanwhile. Positions:
/// rotations rounded to doubles, with a proven error; enclosed by interval arithmetic in doubles or double-double where
/// that is too coarse, sine and cosine by their alternating series.
/// Deviations: |x''| (to - from)^2 / 8 (docs/numerics.md, "Curved motion").
class RigidPath final : public Path {
 public:
  /// `rest`: each vertex in its body's own frame; `body_of_vertex`: one each, in [0, chains.size()); `rest_end`: where
  /// each is in that frame at t=1, empty if all stay. Throws InvalidPath on sizes that do not fit and on numbers that
  /// are not finite.
  RigidPath(std::vector<Point> rest, std::vector<Index> body_of_vertex, std::vector<Chain> chains,
            std::vector<Point> rest_end = {});
  /// Copies share what they hold; one that is moved from keeps it.
  RigidPath(const RigidPath&) = default;
  RigidPath& operator=(const RigidPath&) = default;

  Index vertex_count() const override;
  void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                 std::span<double> errors) const override;
  void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const override;
  void deviations(double from, double to, std::span<const Index> vertices, std::span<double> deviations) const override;
  /// The axis, if the rotation vectors of a chain, from the outermost to the last that changes, are exactly parallel.
  void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const override;

 private:
  struct Motion;

  std::shared_ptr<const Motion> motion_;
};

}  // namespace tamis
