#include "bounds/fine_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/assert.hpp"

namespace tamis {
namespace {

double largest_difference(const double* a, const double* b) {
  return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

constexpr std::size_t kFewestVertices = 64;

/// A sample of the vertices, each with its distance to the next vertex by number.
class SomeVertices {
 public:
  /// The sample is so small that its cost is a hundredth of a question's. REQUIRES: kFewestVertices or more.
  SomeVertices(const Step& step, std::span<const Index> used)
      : count_(std::clamp(used.size() / 64, std::min<std::size_t>(used.size() / 8, 32), kMost)) {
    TAMIS_ASSERT(used.size() >= kFewestVertices);
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t at = (2 * i + 1) * used.size() / (2 * count_);
      const Index v = used[at], next = used[at + 1];
      vertices_[i] = v;
      distances_[i] = std::max(largest_difference(step.start[v], step.start[next]),
                               largest_difference(step.end[v], step.end[next]));
    }
    find_shortest();
  }

  /// The third shortest of the distances, as two may be slivers. Skips distances below 2^-24 of the median: such
  /// vertices coincide on purpose, or wait somewhere until they are used.
  double shortest() const { return shortest_; }

  /// Chooses `count` of the sampled vertices: those with up to eight times the shortest distance weigh the same, others
  /// weigh less in inverse proportion to their distance.
  template <std::size_t count>
  std::array<Index, count> finest() const {
    const double fine = std::max(8 * shortest_, std::numeric_limits<double>::min());
    std::array<double, kMost> weights;
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
      sum += weights[i] = distances_[i] < nothing_ ? 0 : fine / std::max(distances_[i], fine);
    std::array<Index, count> chosen;
    double passed = weights[0];
    for (std::size_t n = 0, i = 0; n < count; ++n) {
      while (passed * (2 * count) < sum * static_cast<double>(2 * n + 1) && i + 1 < count_) passed += weights[++i];
      chosen[n] = vertices_[i];
    }
    return chosen;
  }

 private:
  static constexpr std::size_t kMost = 128;

  void find_shortest() {
    constexpr std::ptrdiff_t kSlivers = 2;
    constexpr double kNothing = 0x1p-24;
    std::array<double, kMost> sorted = distances_;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(sorted.begin(), end);
    nothing_ = kNothing * sorted[count_ / 2];
    const auto first = std::lower_bound(sorted.begin(), end, nothing_);
    shortest_ = first[std::min(kSlivers, end - first - 1)];
  }

  std::size_t count_;
  std::array<Index, kMost> vertices_;
  std::array<double, kMost> distances_;
  double shortest_, nothing_;
};

/// Of an odd number of vertices.
template <std::size_t count, class F>
double median(const std::array<Index, count>& vertices, const F& value_of) {
  std::array<double, count> values;
  std::ranges::transform(vertices, values.begin(), value_of);
  std::ranges::nth_element(values, values.begin() + count / 2);
  return values[count / 2];
}

}  // namespace

double FinePlace::distance_to(const double* at_start, const double* at_end) const {
  return std::max(largest_difference(at_start, start.data()), largest_difference(at_end, end.data()));
}

std::optional<FinePlace> place_finer_than(double width, const Step& step, std::span<const Index> used) {
  if (used.size() < kFewestVertices) return {};
  const SomeVertices some(step, used);
  if (!(some.shortest() < width)) return {};
  const std::array<Index, 15> finest = some.finest<15>();
  FinePlace place{};
  for (std::size_t k = 0; k < 3; ++k) {
    place.start[k] = median(finest, [&](Index v) { return step.start[v][k]; });
    place.end[k] = median(finest, [&](Index v) { return step.end[v][k]; });
  }
  place.radius =
      std::max(some.shortest(), median(finest, [&](Index v) { return place.distance_to(step.start[v], step.end[v]); }));
  if (!(place.radius < width)) return {};
  return place;
}

}  // namespace tamis
