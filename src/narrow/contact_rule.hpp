// By what a pair is decided.
#pragma once

namespace tamis {

/// Valid as in PairOptions.
struct ContactRule {
  double min_separation = 0;
  double latest = 1;
};

}  // namespace tamis
