// How far a step may go: all vertices to one time, or each vertex by itself.
#pragma once
#include <optional>
#include <vector>

#include "tamis/positions.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Answer to "how far may the step go while every pair keeps a fraction of its distance?". The distance that counts
/// is what exceeds the minimum separation and both radii.
struct SafeStep {
  /// On [0, toi_lower] every pair keeps at least the fraction, and on [0, toi_lower) none touches: proven. It is 1 if
  /// the whole step may go. It is 0 only if a pair touches (is within the minimum separation) at t=0 and is not
  /// ignored, or loses its part sooner than at any positive double (toi_upper > 0).
  double toi_lower = 1;
  /// At this time some pair has no more than the fraction left: proven. 1 if that is not known of any time.
  double toi_upper = 1;
  /// The pair that ends the step at `toi_lower`, as it is at t=0. (On a path: at positions rounded to doubles.) None if
  /// the whole step may go.
  std::optional<NearPair> pair;
};

/// Where each vertex may go, on its own line from the start of the step towards its end.
struct TruncatedStep {
  /// One a vertex: the position to go to. On the straight way from the start of the step to these very doubles, every
  /// pair is proven to keep the fraction of its distance. The distance that counts is what exceeds the minimum
  /// separation and both radii. A pair that starts within these keeps all of its distance but a millionth, or none of
  /// its vertices moves. A pair that is ignored at the start (AtStart) does not come back within these once it is
  /// apart.
  std::vector<Point> positions;
  /// One a vertex: the fraction of its way that it goes, in [0, 1]; 1 for vertices that take no part in contacts. start
  /// + fraction (end - start), rounded, may differ from `positions`.
  std::vector<double> fractions;
  /// Whether the way to `positions` is free of contacts. False if some pair touches (is within the minimum separation)
  /// at the start and is not ignored.
  bool is_free = true;
};

}  // namespace tamis
