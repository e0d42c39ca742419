// The rule by which a pair is decided: separation and latest time of interest.
#pragma once

namespace tamis {

/// Valid as in PairOptions.
struct ContactRule {
  double min_separation = 0;
  double latest = 1;
};

}  // namespace tamis
