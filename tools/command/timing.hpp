// One question asked several times of one detector or world.
#pragma once
#include <algorithm>
#include <vector>

#include "tamis/statistics.hpp"

namespace tamis::cli {

struct Timing {
  Seconds cold;  ///< the first run: the hierarchy is built
  Seconds warm;  ///< the later run of median total, whose parts add up; the first run if it is the only one

  /// Adds the times of another question.
  Timing& operator+=(const Timing& other) {
    cold += other.cold;
    warm += other.warm;
    return *this;
  }
};

/// REQUIRES: repeat >= 1. The answer is that of the last run.
template <class Asked, class Ask>
Timing ask_repeatedly(Asked& asked, int repeat, const Ask& ask) {
  std::vector<Seconds> runs;
  for (int run = 0; run < repeat; ++run) {
    ask();
    runs.push_back(asked.statistics().seconds);
  }
  Timing timing{runs.front(), runs.front()};
  if (repeat == 1) return timing;
  const auto middle = runs.begin() + 1 + (repeat - 1) / 2;
  std::nth_element(runs.begin() + 1, middle, runs.end(),
                   [](const Seconds& a, const Seconds& b) { return a.total < b.total; });
  timing.warm = *middle;
  return timing;
}

}  // namespace tamis::cli
