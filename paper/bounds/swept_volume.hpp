// The interface that the paper's hierarchy needs of a bounding volume V of moving features, over the whole step:
//   V::around(points, origin, padding)  bounds coordinates of MovingPoints, blown up by a Euclidean distance
//   merge(a, b)                         contains both
//   overlap(a, b)                       false only if the two provably share no point, rounding included
//   extent()                            a length, by which the cost of a tree is measured
#pragma once
#include <span>

#include "paper/bounds/k_dop.hpp"

namespace tamis::lab {

template <class Volume>
inline Volume volume_around(std::span<const Moving<double>> points, const Vec3<double>& origin, double padding) {
  if constexpr (requires { Volume::around(points[0], origin, padding); }) {
    Volume volume = Volume::around(points[0], origin, padding);
    for (std::size_t i = 1; i < points.size(); ++i) volume = merge(volume, Volume::around(points[i], origin, padding));
    return volume;
  } else {
    return Volume::around(points, origin, padding);
  }
}

}  // namespace tamis::lab
