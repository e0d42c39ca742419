// Curved motion: where every vertex is at each time of a step, and how far it deviates from straight pieces.
#pragma once
#include <array>
#include <span>

#include "tamis/pair.hpp"

namespace tamis {

/// A position known better than to a double: within `error` of high + low, on each axis.
struct FinePoint {
  Point high{0, 0, 0};
  Point low{0, 0, 0};
  double error = 0;
};

/// How all vertices move for t in [0,1], on continuous curves. Derive from it, or take a ready-made one
/// (tamis/rigid_path.hpp, tamis/spline_path.hpp). All calls are const and may come from several threads at a time.
/// Every answer is as true as what the path promises: bounds must hold beyond its own rounding.
class Path {
 public:
  virtual ~Path() = default;

  virtual Index vertex_count() const = 0;

  /// Where the vertices are at `time` in [0,1], one point and one error each: no coordinate is off by more than the
  /// error, >= 0, in the unit of the positions.
  virtual void points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                         std::span<double> errors) const = 0;

  /// The same, as precisely as the path can: asked for pairs that points_at leaves undecided. By default points_at.
  virtual void fine_points_at(double time, std::span<const Index> vertices, std::span<FinePoint> points) const;

  /// For each vertex a bound, >= 0, of its deviation on [from, to]: at no time t of it is the vertex farther
  /// (Euclidean) than that from ((to - t) x(from) + (t - from) x(to)) / (to - from), the chord walked at constant
  /// speed. It must go to zero as the piece gets shorter, for smooth curves with its square: |x''| (to - from)^2 / 8.
  virtual void deviations(double from, double to, std::span<const Index> vertices,
                          std::span<double> deviations) const = 0;

  /// For each vertex a direction d, of any length, along which it moves uniformly although its curve bends: d.x(t) is
  /// linear in t, exactly, for d as written, so that deviations are orthogonal to d. Zeros where none is known, as by
  /// default. A body that turns about a fixed axis has one; bodies that slide on planes across it are told apart by it.
  virtual void straight_directions(std::span<const Index> vertices, std::span<Point> directions) const;
};

/// A vertex against a face that move on a path: p, then the face's corners a b c, by their numbers in the path. As
/// vertex_face for straight motion: free is proven; a certified contact's bracket is no wider than the tolerance. What
/// double-double arithmetic cannot decide (a touch without crossing, a crossing exactly on an edge) is an unresolved
/// contact; with a separation doubles have the last word (docs/numerics.md, "Curved motion"). Throws InvalidPath where
/// the path breaks its promises or has no such vertex, InvalidOptions.
PairResult vertex_face(const Path& path, const std::array<Index, 4>& vertices, const PairOptions& = {});
/// Edge (0,1) against edge (2,3); otherwise the same.
PairResult edge_edge(const Path& path, const std::array<Index, 4>& vertices, const PairOptions& = {});
/// A point against a segment; otherwise the same.
PairResult vertex_edge(const Path& path, const std::array<Index, 3>& vertices, const PairOptions& = {});
/// Two points; otherwise the same.
PairResult vertex_vertex(const Path& path, const std::array<Index, 2>& vertices, const PairOptions& = {});

}  // namespace tamis
