// Curved motion. A path tells where every vertex is at each time of a step, and how far it deviates from straight
// pieces.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "tamis/pair.hpp"

namespace tamis {

/// A position more precise than a double: high + low, off by at most `error` on each axis.
struct FinePoint {
  Point high{0, 0, 0};  ///< leading doubles
  Point low{0, 0, 0};   ///< added to them
  double error = 0;     ///< bound on each axis
};

struct CarriedPath;

/// How all vertices move for t in [0,1], on continuous curves. Derive from it, or take a ready-made path
/// (tamis/rigid_path.hpp, tamis/spline_path.hpp). All calls are const and may come from several threads at a time.
/// Answers are only as true as the path's bounds. These must hold in spite of the path's own rounding.
class Path {
 public:
  virtual ~Path() = default;

  /// Returns the number of vertices.
  virtual Index vertex_count() const = 0;

  /// Computes where the vertices are at `time` in [0,1].
  /// Writes one point and one error for each. No coordinate is off by more than the error, >= 0, in the unit of the
  /// positions.
  virtual void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                         std::span<double> errors) const = 0;

  /// Computes the same as precisely as the path can, for pairs that points_at leaves undecided.
  /// Writes one fine point for each; by default the positions of points_at.
  virtual void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const;

  /// Bounds the deviation of each vertex. The deviation is its Euclidean distance, at any time t of [from, to], from
  /// ((to - t) x(from) + (t - from) x(to)) / (to - from). The latter point goes along the chord at constant speed.
  /// Writes a bound, >= 0, for each. The bound must go to zero as the piece gets shorter, for smooth curves with the
  /// square of its length: |x''| (to - from)^2 / 8.
  virtual void deviations(double from, double to, std::span<const Index> vertices,
                          std::span<double> deviations) const = 0;

  /// Finds for each vertex a direction d, of any length, along which it moves at constant speed although its curve
  /// bends. So d.x(t) is linear in t, exactly, for d as stored. So deviations are orthogonal to d. A body that turns
  /// about a fixed axis has such a direction, its axis. Bodies that slide past each other on planes orthogonal to d are
  /// proven apart by it.
  /// Writes the directions. Zeros where none is known; by default all are zeros.
  virtual void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const;

  /// Finds the motion of a pair's vertices in a frame that one rigid motion carries. Two bodies that a third one holds
  /// have the motion of the third. Pairs are decided in that frame.
  /// Returns the motion in the frame, or none if the path knows no such frame. By default none.
  virtual std::optional<CarriedPath> carried(std::span<const Index> vertices) const;
};

/// Vertices of a path in a frame that moves rigidly. Distances are the same at all times, exactly.
struct CarriedPath {
  std::shared_ptr<const Path> path;  ///< its vertex i is the i-th of the given ones
  bool is_still = false;             ///< no vertex moves in the frame
  /// Turns a direction in the frame at a time into one in the world.
  std::function<Point(double time, const Point& direction)> to_world;
};

/// Decides a vertex p against a face a b c that move on a path; `vertices` holds their numbers in the path.
/// Returns the answer as vertex_face for straight motion. Free is proven. A certified contact has a bracket no wider
/// than the tolerance. A pair that double-double arithmetic cannot decide (a touch without crossing, a crossing exactly
/// on an edge) is an unresolved contact. With a separation a pair is unresolved if doubles cannot decide it
/// (docs/numerics/curves.md, "Curved motion").
/// Throws InvalidPath if the path breaks its promises or has no such vertex. Throws InvalidOptions on an option outside
/// its range.
[[nodiscard]] PairResult vertex_face(const Path& path, const std::array<Index, 4>& vertices, const PairOptions& = {});
/// Decides edge (0,1) against edge (2,3); otherwise the same.
[[nodiscard]] PairResult edge_edge(const Path& path, const std::array<Index, 4>& vertices, const PairOptions& = {});
/// Decides a point against a segment; otherwise the same.
[[nodiscard]] PairResult vertex_edge(const Path& path, const std::array<Index, 3>& vertices, const PairOptions& = {});
/// Decides two points; otherwise the same.
[[nodiscard]] PairResult vertex_vertex(const Path& path, const std::array<Index, 2>& vertices, const PairOptions& = {});

}  // namespace tamis
