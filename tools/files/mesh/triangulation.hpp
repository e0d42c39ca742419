// Cuts a polygon into triangles that stay inside it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "files/mesh/orientation.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// What the triangles of a polygon cannot show.
struct PolygonDoubts {
  bool is_bent = false;     ///< its corners leave a plane by more than kFlat of its size
  bool is_tangled = false;  ///< it crosses itself, or has no area
};

/// As a part of a polygon's size: rounding to four digits is below it.
inline constexpr double kFlat = 1e-3;

/// Decides in the plane of two axes in which the polygon is largest, exactly. The fan from the first corner is taken
/// where it stays inside: in every convex polygon without three corners on a line, and in some others. Else ears are
/// clipped, so that no corner lies inside a triangle or on its sides. A tangled polygon is cut into the fan: then
/// triangles overlap.
class Triangulation {
 public:
  /// Appends the triangles of one polygon; an index that directly follows itself counts once. Positions that are not
  /// finite give the fan. REQUIRES: three corners or more, each the index of a position.
  PolygonDoubts cut(std::span<const Index> corners, std::span<const Point> positions, std::vector<Face>& faces);

 private:
  void take_corners(std::span<const Index> corners);
  bool project(std::span<const Point> positions, PolygonDoubts& doubts);
  int turn_of(std::span<const Point> points, std::size_t axis) const;
  bool is_fan_inside() const;
  bool crosses_itself() const;
  bool clip_ears(std::vector<Face>& faces);
  bool is_ear(std::size_t tip) const;
  bool leads_inside(std::size_t corner, std::size_t tip, std::size_t other) const;
  bool is_spike(std::size_t tip) const;
  void clip(std::size_t tip, std::vector<Face>& faces);
  void add_fan(std::vector<Face>& faces) const;
  std::size_t size() const { return corners_.size(); }

  std::vector<Index> corners_;
  std::vector<Point> scaled_;
  std::vector<PlanePoint> plane_;            ///< of each corner; the polygon runs counter-clockwise
  std::vector<std::size_t> by_x_;            ///< corners in the order of x
  std::vector<std::size_t> before_, after_;  ///< neighbours of each corner that is left
  std::vector<bool> is_left_;
  std::size_t left_ = 0;
};

}  // namespace tamis::io
