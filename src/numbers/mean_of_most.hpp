// A mean that a few large numbers do not decide.
#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>

namespace tamis {

inline constexpr double kMuchLarger = 32;

/// The mean of value_of(0), value_of(stride), ... below `count`, of values up to `most`. As long as a value is more
/// than kMuchLarger times the mean, only values up to the mean are kept. 0 of no values; always finite. REQUIRES (not
/// checked: O(n)): values >= 0.
template <class F>
double mean_of_most(std::size_t count, std::size_t stride, const F& value_of,
                    double most = std::numeric_limits<double>::infinity()) {
  for (;;) {
    double sum = 0, largest = 0;
    std::size_t values = 0;
    for (std::size_t i = 0; i < count; i += stride) {
      const double value = value_of(i);
      if (!(value <= most)) continue;
      sum += value;
      largest = std::max(largest, value);
      ++values;
    }
    const double mean =
        values > 0 ? std::min(sum / static_cast<double>(values), std::numeric_limits<double>::max()) : 0;
    if (!(largest > kMuchLarger * mean)) return mean;
    most = mean;
  }
}

}  // namespace tamis
