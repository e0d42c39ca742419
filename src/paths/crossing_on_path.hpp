// The first contact of a pair without a separation on its path. Cuts the path in time until each part is proven free or
// holds a crossing: the coplanarity d.(e x f) has different signs at the part's ends.
#pragma once
#include "paths/decide_path.hpp"

namespace tamis {

/// The sign of the coplanarity at one time; 0 if its interval holds zero.
template <class T>
int side_of(const Vec3<BasicInterval<T>>& e, const Vec3<BasicInterval<T>>& f, const Vec3<BasicInterval<T>>& d) {
  const BasicInterval<T> k = dot(d, cross(e, f));
  return k.lower > T(0) ? 1 : k.upper < T(0) ? -1 : 0;
}

/// decide_on_path for a pair without a separation. REQUIRES: `time` is a part of [0,1]. REQUIRES (not checked:
/// history): `reader` reads the question's pair.
Decision first_crossing_on_path(const PathQuestion& question, const PairReader& reader,
                                const TimeInterval<double>& time);

}  // namespace tamis
