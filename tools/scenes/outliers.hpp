// Outliers, as simulations have them: a few vertices, or most of them, are far from all else.
#pragma once
#include "scenes/scene.hpp"

namespace tamis::scenes {

enum class Outliers {
  fallen_triangles,  ///< two, far away: a corner of one ends on the other, in a plane x + y = constant
  flying_triangle,   ///< a triangle that passes by
  wide_ground,       ///< a triangle below everything
  wide_terrain,      ///< a plain below everything and slopes, with twice the scene's vertices
  lost_vertex,       ///< one of the scene's own, in the middle of its list
  flying_vertex,     ///< the same, but it starts at its place
};

/// Puts outliers at `distance`, in the unit of the positions. New vertices and faces come last.
void add_outliers(Scene& scene, Outliers which, double distance);

}  // namespace tamis::scenes
