// Questions about a mesh at rest.
#pragma once
#include <vector>

#include "motion/separations.hpp"
#include "tamis/near.hpp"
#include "tamis/statistics.hpp"
#include "tamis/step.hpp"

namespace tamis {

class RestEngine {
 public:
  virtual ~RestEngine() = default;

  /// Every pair within its separation, by kind, then vertices. Adds stages, seconds (but `total`), counts and `rebuilt`
  /// to `statistics`. REQUIRES: validated positions. Runs in the caller's oneTBB arena.
  virtual void find_near(const Positions& positions, const Separations& separations, std::vector<NearPair>& pairs,
                         Statistics& statistics) = 0;
};

}  // namespace tamis
