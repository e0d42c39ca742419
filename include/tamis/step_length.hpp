// How far a step may go: all vertices alike, or each by itself.
#pragma once
#include <optional>
#include <vector>

#include "tamis/positions.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// Answer to "how far may the step go so that every pair keeps a fraction of its distance?". The distance that counts
/// is what exceeds the minimum separation.
struct SafeStep {
  /// On [0, lower] every pair keeps at least the fraction, and on [0, lower) none touches: proven. 1 if the whole step
  /// may go; 0 only if a pair touches (comes within the minimum separation) at t=0, and is not ignored for it, or
  /// (upper > 0) may have lost its part sooner than at any positive double.
  double lower = 1;
  /// At this time some pair has no more than the fraction left: proven; 1 if that is not known of any time.
  double upper = 1;
  /// The pair that ends the step at `lower`, as it is at t=0 (on a path, of the positions as rounded); none if the
  /// whole step may go.
  std::optional<NearPair> pair;
};

/// Where a step may end, each vertex on its own line towards its end.
struct TruncatedStep {
  /// One a vertex: where to go. On the straight way there from the start of the step, to these very doubles, every pair
  /// keeps the fraction of its distance, as far as that exceeds the minimum separation and both radii: proven. A pair
  /// that starts within those keeps all of its distance but a millionth, or none of its vertices moves; one that is
  /// ignored for it (AtStart) does not come back to them once it has left them.
  std::vector<Point> positions;
  /// One a vertex: how much of its way it goes, in [0, 1], 1 for vertices that take no part in contacts. What
  /// start + fraction (end - start) is rounded to need not be `positions`.
  std::vector<double> fractions;
  /// The whole way is free of contacts. False: some pair touches (is within the minimum separation) at the start, and
  /// is not ignored for it.
  bool is_free = true;
};

}  // namespace tamis
