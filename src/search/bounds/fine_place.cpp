#include "search/bounds/fine_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numbers/assert.hpp"

namespace tamis {
namespace {

double largest_difference(const double* a, const double* b) {
  return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

constexpr std::size_t kMostPairs = kMostSampled / 2;

/// A sample of the vertices, each with its distance to the next vertex by number.
class SomeVertices {
 public:
  /// REQUIRES: a sample, and not an empty one.
  explicit SomeVertices(std::span<const SampledVertex> sample) : sample_(sample), count_(sample.size() / 2) {
    TAMIS_ASSERT(count_ > 0 && count_ <= kMostPairs);
    for (std::size_t i = 0; i < count_; ++i) {
      const SampledVertex &v = sample[2 * i], &next = sample[2 * i + 1];
      distances_[i] = std::max(largest_difference(v.start.data(), next.start.data()),
                               largest_difference(v.end.data(), next.end.data()));
    }
    find_shortest();
  }

  /// The third shortest of the distances, as two may be slivers. Skips distances below 2^-24 of the median. Such
  /// vertices coincide on purpose, or wait somewhere until they are used.
  double shortest() const { return shortest_; }

  /// Chooses `count` of the sampled vertices: those with up to eight times the shortest distance weigh the same. Others
  /// weigh less in inverse proportion to their distance.
  template <std::size_t count>
  std::array<SampledVertex, count> finest() const {
    const double fine = std::max(8 * shortest_, std::numeric_limits<double>::min());
    std::array<double, kMostPairs> weights;
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
      sum += weights[i] = distances_[i] < nothing_ ? 0 : fine / std::max(distances_[i], fine);
    std::array<SampledVertex, count> chosen;
    double passed = weights[0];
    for (std::size_t n = 0, i = 0; n < count; ++n) {
      while (passed * (2 * count) < sum * static_cast<double>(2 * n + 1) && i + 1 < count_) passed += weights[++i];
      chosen[n] = sample_[2 * i];
    }
    return chosen;
  }

 private:
  void find_shortest() {
    constexpr std::ptrdiff_t kSlivers = 2;
    constexpr double kNothing = 0x1p-24;
    std::array<double, kMostPairs> sorted;
    const auto end = std::copy_n(distances_.begin(), count_, sorted.begin());
    std::sort(sorted.begin(), end);
    nothing_ = kNothing * sorted[count_ / 2];
    const auto first = std::lower_bound(sorted.begin(), end, nothing_);
    shortest_ = first[std::min(kSlivers, end - first - 1)];
  }

  std::span<const SampledVertex> sample_;
  std::size_t count_;
  std::array<double, kMostPairs> distances_;
  double shortest_, nothing_;
};

/// Of an odd number of vertices.
template <std::size_t count, class F>
double median(const std::array<SampledVertex, count>& vertices, const F& value_of) {
  std::array<double, count> values;
  std::ranges::transform(vertices, values.begin(), value_of);
  std::ranges::nth_element(values, values.begin() + count / 2);
  return values[count / 2];
}

}  // namespace

double FinePlace::distance_to(const double* at_start, const double* at_end) const {
  return std::max(largest_difference(at_start, start.data()), largest_difference(at_end, end.data()));
}

/// So few that their cost is a hundredth of a question's.
std::size_t sample_size(std::size_t count) {
  constexpr std::size_t kFewestVertices = 64;
  return count < kFewestVertices ? 0 : 2 * std::clamp(count / 64, std::min<std::size_t>(count / 8, 32), kMostPairs);
}

std::size_t sample_place(std::size_t count, std::size_t i) {
  const std::size_t size = sample_size(count);
  TAMIS_ASSERT(i < size);
  return static_cast<std::size_t>(std::uint64_t{i - i % 2 + 1} * count / size) + i % 2;
}

std::optional<FinePlace> place_finer_than(double width, std::span<const SampledVertex> sample) {
  if (sample.empty()) return {};
  const SomeVertices some(sample);
  if (!(some.shortest() < width)) return {};
  const std::array<SampledVertex, 15> finest = some.finest<15>();
  FinePlace place{};
  for (std::size_t k = 0; k < 3; ++k) {
    place.start[k] = median(finest, [&](const SampledVertex& v) { return v.start[k]; });
    place.end[k] = median(finest, [&](const SampledVertex& v) { return v.end[k]; });
  }
  place.radius =
      std::max(some.shortest(),
               median(finest, [&](const SampledVertex& v) { return place.distance_to(v.start.data(), v.end.data()); }));
  if (!(place.radius < width)) return {};
  return place;
}

}  // namespace tamis
