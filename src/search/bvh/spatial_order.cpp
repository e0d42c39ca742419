#include "search/bvh/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "numbers/in_parts.hpp"
#include "search/bounds/moving_boxes.hpp"

namespace tamis {
namespace {

/// Up to this many centers are sorted at once.
constexpr std::size_t kFew = 32;

/// For each number, how many are less than it. Has no branches: the compiler makes lanes of it.
template <std::size_t size>
std::array<std::int32_t, size> lower_than_each(const std::array<float, size>& numbers) {
  std::array<std::int32_t, size> lower{};
  for (std::size_t j = 0; j < size; ++j) {
    const float other = numbers[j];
    for (std::size_t i = 0; i < size; ++i) lower[i] += other < numbers[i] ? 1 : 0;
  }
  return lower;
}

/// A pivot from a sample, a little beyond rank `wanted`, on the side that leaves fewer centers (Floyd, Rivest 1975).
template <std::size_t size, int axes>
float pivot_near(std::span<const Center<axes>> centers, std::size_t wanted, int axis) {
  constexpr std::uint32_t kGoldenRatio = 0x9e3779b9;  // of 2^32; equal steps can meet the period of a grid
  constexpr auto kSize = static_cast<std::int32_t>(size), kBeyond = kSize / 16;
  std::array<float, size> sample;
  std::uint32_t place = 0;
  for (float& x : sample) {
    x = centers[std::uint64_t{place} * centers.size() >> 32].at[axis];
    place += kGoldenRatio;
  }
  const auto near = static_cast<std::int32_t>(wanted * size / centers.size());
  const std::int32_t rank = near + (near <= kSize / 2 ? kBeyond : -kBeyond);
  const auto lower = lower_than_each(sample);
  float pivot = sample[0];
  std::int32_t most = -1;
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_better = lower[i] <= rank && lower[i] > most;
    pivot = is_better ? sample[i] : pivot;
    most = is_better ? lower[i] : most;
  }
  return pivot;
}

/// Sorts at most kFew centers along an axis.
template <int axes>
void sort_few(std::span<Center<axes>> centers, int axis) {
  std::array<float, kFew> numbers;
  numbers.fill(std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < centers.size(); ++i) numbers[i] = centers[i].at[axis];
  auto places = lower_than_each(numbers);
  std::array<Center<axes>, kFew> unsorted;
  std::ranges::copy(centers, unsorted.begin());
  std::array<std::uint8_t, kFew> equal{};
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const auto lower = static_cast<std::size_t>(places[i]);
    centers[lower + equal[lower]++] = unsorted[i];
  }
}

/// Moves the centers for which is_low(x) to the front, without branches. Returns their number.
template <int axes, class IsLow>
std::size_t partition_along(std::span<Center<axes>> centers, int axis, const IsLow& is_low) {
  using Raw = std::array<std::uint64_t, sizeof(Center<axes>) / 8>;  // copied member by member it takes twice as long
  std::size_t lows = 0;
  for (Center<axes>& center : centers) {
    const bool is = is_low(center.at[axis]);
    const Raw one = std::bit_cast<Raw>(center), other = std::bit_cast<Raw>(centers[lows]);
    std::memcpy(&centers[lows], &one, sizeof one);
    std::memcpy(&center, &other, sizeof other);
    lows += is;
  }
  return lows;
}

/// Moves the `lower` lowest centers along an axis to the front.
template <int axes>
void select(std::span<Center<axes>> centers, std::size_t lower, int axis) {
  constexpr std::size_t kSmallSample = 512;  // a sample of 32 takes longer than it saves below
  while (centers.size() > kFew) {
    const std::span<const Center<axes>> all = centers;
    const float pivot = all.size() < kSmallSample ? pivot_near<16>(all, lower, axis) : pivot_near<32>(all, lower, axis);
    std::size_t lows = partition_along(centers, axis, [&](float x) { return x < pivot; });
    if (lows == 0) {
      lows = partition_along(centers, axis, [&](float x) { return x <= pivot; });
      if (lower <= lows) return;  // the lowest are all equal
    }
    if (lower == lows) return;
    const bool is_low = lower < lows;
    centers = is_low ? centers.first(lows) : centers.subspan(lows);
    lower -= is_low ? 0 : lows;
  }
  sort_few(centers, axis);
}

/// The axis along which the centers spread most. If there are many centers, takes a sample.
template <int axes>
int longest_axis(std::span<const Center<axes>> centers) {
  constexpr std::size_t kSample = 256;
  return [&]<std::size_t... axis>(std::index_sequence<axis...>) {
    float low[] = {centers[0].at[axis]...}, high[] = {centers[0].at[axis]...};
    for (std::size_t i = 1; i < centers.size(); i += 1 + centers.size() / kSample) {
      ((low[axis] = std::min(low[axis], centers[i].at[axis])), ...);
      ((high[axis] = std::max(high[axis], centers[i].at[axis])), ...);
    }
    int longest = 0;
    for (int k = 1; k < axes; ++k)
      if (high[k] - low[k] > high[longest] - low[longest]) longest = k;
    return longest;
  }
  (std::make_index_sequence<axes>());
}

template <int axes>
struct Halving {
  const std::span<Center<axes>> centers;
  const Pause& pause;
  const std::span<const std::size_t> ends;  ///< of groups

  /// Cuts centers [first, end) at `cut`. Centers change places only within the group that the cut goes through.
  void split(std::size_t first, std::size_t end, std::size_t cut) const {
    const auto next = std::ranges::upper_bound(ends, cut);
    const std::size_t from = next == ends.begin() ? first : std::max(first, *std::prev(next));
    const std::size_t to = next == ends.end() ? end : std::min(end, *next);
    if (from == cut) return;
    const auto group = centers.subspan(from, to - from);
    select(group, cut - from, longest_axis<axes>(group));
  }

  /// Cuts between blocks of the largest level of which the range has several. Such cuts make every block of every level
  /// of the tree. Returns the cut.
  std::size_t halve_once(std::size_t first, std::size_t end) const {
    const std::size_t count = end - first;
    if (count <= kBlock) return end;
    std::size_t unit = kBlock;
    while (unit * kBlock < count) unit *= kBlock;
    const std::size_t blocks = (count + unit - 1) / unit, cut = first + (blocks + 1) / 2 * unit;
    split(first, end, cut);
    return cut;
  }
  void halve(std::size_t first, std::size_t end) const {
    constexpr std::size_t kCentersPerPause = 8192;
    if (end - first <= kBlock) return;
    if (end - first >= kCentersPerPause) pause();
    const std::size_t cut = halve_once(first, end);
    halve(first, cut);
    halve(cut, end);
  }
  /// The same for all of `centers`. Threads share the ranges, as long as these are long.
  void halve_all() const {
    constexpr std::size_t kLongRange = 8192;
    std::vector<std::size_t> cuts{0, centers.size()};
    for (std::size_t length = centers.size(); has_other_threads() && length >= kLongRange; length /= 2) {
      pause();
      const std::size_t ranges = cuts.size() - 1;
      std::vector<std::size_t> all(2 * ranges + 1, centers.size());
      in_parts(ranges, std::size_t{1}, [&](std::size_t i, std::size_t end) {
        for (; i != end; ++i) {
          all[2 * i] = cuts[i];
          all[2 * i + 1] = halve_once(cuts[i], cuts[i + 1]);
        }
      });
      cuts = std::move(all);
    }
    in_parts(cuts.size() - 1, std::size_t{1}, [&](std::size_t i, std::size_t end) {
      for (; i != end; ++i) halve(cuts[i], cuts[i + 1]);
    });
  }
};

}  // namespace

template <int axes>
void order_in_space(std::span<Center<axes>> centers, const Pause& pause, std::span<const std::size_t> ends) {
  Halving<axes>{centers, pause, ends}.halve_all();
}
template void order_in_space(std::span<Center<3>>, const Pause&, std::span<const std::size_t>);
template void order_in_space(std::span<Center<6>>, const Pause&, std::span<const std::size_t>);

}  // namespace tamis
