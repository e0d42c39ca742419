// Processor time, and medians of times.
#pragma once
#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace tamis::bench {

/// Of all threads of this process, from an arbitrary start.
inline double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Of an even number of values the upper one of both in the middle.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace tamis::bench
