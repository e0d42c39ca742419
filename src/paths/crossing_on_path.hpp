// Where a pair without a separation first touches on its path: cut in time, until each part is proven free or holds a
// crossing, which is a part at whose ends the coplanarity has different signs.
#pragma once
#include "paths/decide_path.hpp"

namespace tamis {

/// The sign of the coplanarity at one time: 0 if that is not known.
template <class T>
int side_of(const Vec3<BasicInterval<T>>& e, const Vec3<BasicInterval<T>>& f, const Vec3<BasicInterval<T>>& d) {
  const BasicInterval<T> k = dot(d, cross(e, f));
  return k.lower > T(0) ? 1 : k.upper < T(0) ? -1 : 0;
}

/// As decide_on_path, of a pair without a separation. REQUIRES: a part of the path. REQUIRES (not checked: history):
/// `reader` reads the question's pair.
Decision first_crossing_on_path(const PathQuestion& question, const PairReader& reader,
                                const TimeInterval<double>& time);

}  // namespace tamis
