// How far a step may go: all vertices to one time, or each vertex by itself.
#pragma once
#include <optional>
#include <vector>

#include "tamis/positions.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Answer to "how far may the step go while every pair keeps a fraction of its distance?". The minimum separation and
/// both radii are subtracted from the distance.
struct SafeStep {
  /// Proven: on [0, toi_lower] every pair keeps at least the fraction, and on [0, toi_lower) none touches. It is 1 if
  /// the whole step may go. It is 0 in two cases. A pair touches (is within the minimum separation) at t=0 and is not
  /// ignored. Or a pair loses its part sooner than at any positive double (toi_upper > 0).
  double toi_lower = 1;
  /// Proven: at this time some pair has at most the fraction left. 1 if no such time is known.
  double toi_upper = 1;
  /// The pair that ends the step at `toi_lower`, as it is at t=0. (On a path: at positions rounded to doubles.) None if
  /// the whole step may go.
  std::optional<NearPair> pair;
};

/// Where each vertex may go, on its own line from the start of the step towards its end.
struct TruncatedStep {
  /// One a vertex: the position to go to. Every pair is proven to keep the fraction of its distance on the straight way
  /// from the start of the step to these doubles. The minimum separation and both radii are subtracted from the
  /// distance. A pair may start within them. Then it keeps all of its distance but a millionth, or none of its vertices
  /// moves. A pair that is ignored at the start (AtStart) does not come back within them once it is apart.
  std::vector<Point> positions;
  /// One a vertex: the fraction of its way that it goes, in [0, 1]. It is 1 for vertices that take no part in contacts.
  /// The rounded sum start + fraction (end - start) may differ from `positions`.
  std::vector<double> fractions;
  /// Whether the way to `positions` is free of contacts. False if some pair touches (is within the minimum separation)
  /// at the start and is not ignored.
  bool is_free = true;
};

}  // namespace tamis
