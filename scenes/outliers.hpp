// What is far from all else, as simulations have it: a few vertices, or most of them.
#pragma once
#include "scenes/scene.hpp"

namespace tamis::scenes {

enum class Outliers {
  fallen_triangles,  ///< two, far away: a corner of one ends on the other, in a plane of x + y
  flying_triangle,   ///< which passes by
  wide_ground,       ///< a triangle below everything
  wide_terrain,      ///< a plain below everything and slopes, with twice the scene's vertices
  lost_vertex,       ///< one of the scene's own, in the middle of its list
  flying_vertex,     ///< the same, but it starts at its place
};

/// As far as `distance`, in the unit of the positions; what is new comes last.
void add_outliers(Scene& scene, Outliers which, double distance);

}  // namespace tamis::scenes
