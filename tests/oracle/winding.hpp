// The oracle of insides: counts the faces that a ray crosses, in fractions.
#pragma once
#include <vector>

#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"

namespace tamis::oracle {

struct Crossings {
  int winding = 0;  ///< each face counts 1 or -1, by its winding
  int count = 0;
};

/// Of a ray in any direction. It tries other directions until the ray meets no edge. REQUIRES: the point is on no face.
Crossings crossings(const Point& origin, const std::vector<Point>& points, const std::vector<Face>& faces);

}  // namespace tamis::oracle
