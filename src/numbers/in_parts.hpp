// Parallel loops, if they are long enough.
#pragma once
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <mutex>
#include <span>

#include "numbers/parallel.hpp"

namespace tamis {

/// Vertices in a part of a loop that does little with each of them. A part takes ten to twenty microseconds.
inline constexpr std::size_t kVerticesPerPart = 1024;

inline bool has_other_threads() { return threads_here() > 1; }

/// Calls f(begin, end) for parts of 0 to `count`. A loop no longer than `grain` stays with this thread. Handing it over
/// costs a tenth of a whole question about a mesh of a dozen triangles. Without other threads, parts are sixteen times
/// as long. They are short enough that a check for cancellation between them runs often, and so few that they cost
/// nothing.
template <class Count, class F>
void in_parts(Count count, Count grain, const F& f) {
  if (count > grain && has_other_threads())
    return parallel_for(
        static_cast<std::size_t>(count), static_cast<std::size_t>(grain),
        [&](std::size_t begin, std::size_t end) { f(static_cast<Count>(begin), static_cast<Count>(end)); });
  const Count larger = 16 * grain;
  for (Count begin = 0; begin < count; begin += std::min(larger, count - begin))
    f(begin, begin + std::min(larger, count - begin));
}

/// Calls f(item) for all items, in parts.
template <class Items, class F>
void for_each_in_parts(const Items& items, std::size_t grain, const F& f) {
  in_parts(items.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (; begin != end; ++begin) f(items[begin]);
  });
}

/// Joins f(begin, end) of all parts: a flag, a count, a largest or least value, a box. The result is the same however
/// the loop is parted, and in whatever order parts are joined. `nothing`: the value of no items. join(a, b): the value
/// of both parts.
template <class Value, class Join, class F>
Value joined_parts(std::size_t count, std::size_t grain, const Value& nothing, const Join& join, const F& f) {
  Value value = nothing;
  std::mutex mutex;
  in_parts(count, grain, [&](std::size_t begin, std::size_t end) {
    const Value of_part = f(begin, end);
    const std::lock_guard lock(mutex);
    value = join(value, of_part);
  });
  return value;
}

/// The same for spans of items.
template <class Item, class Value, class Join, class F>
Value joined_parts(std::span<Item> items, std::size_t grain, const Value& nothing, const Join& join, const F& f) {
  return joined_parts(items.size(), grain, nothing, join,
                      [&](std::size_t begin, std::size_t end) { return f(items.subspan(begin, end - begin)); });
}

/// True if is_so(item) holds for all items. Once it has failed for one, parts that have not begun are skipped.
template <class Item, class F>
bool all_in_parts(std::span<const Item> items, std::size_t grain, const F& is_so) {
  std::atomic<bool> are_so = true;
  in_parts(items.size(), grain, [&](std::size_t begin, std::size_t end) {
    if (are_so && !std::ranges::all_of(items.subspan(begin, end - begin), is_so)) are_so = false;
  });
  return are_so;
}

/// An order for a sort that calls pause() now and then, from the threads that sort. An exception that it throws leaves
/// the items in no order. Keeps references.
template <class Order, class Pause>
auto pausing(const Order& comes_before, const Pause& pause) {
  return [&comes_before, &pause](const auto& a, const auto& b) {
    constexpr unsigned kComparisonsPerPause = 1U << 14;  // below a millisecond
    static thread_local unsigned compared = 0;
    if (++compared % kComparisonsPerPause == 0) pause();
    return comes_before(a, b);
  };
}

/// Sorts by a total order. Only equal items are neither before nor after each other. `pause`: as in pausing().
template <class Items, class Order, class Pause>
void sort_in_parts(Items& items, const Order& comes_before, const Pause& pause) {
  constexpr std::size_t kLeast = 1024;  // items of a part
  const auto order = pausing(comes_before, pause);
  const std::size_t count = items.size(), parts = std::bit_ceil(static_cast<std::size_t>(threads_here()));
  if (parts == 1 || count < parts * kLeast) return std::sort(items.begin(), items.end(), order);
  const auto place = [&](std::size_t part) {
    return items.begin() + static_cast<std::ptrdiff_t>(count * part / parts);
  };
  const auto for_each = [&](std::size_t some, const auto& f) {
    parallel_for(some, 1, [&](std::size_t i, std::size_t end) {
      for (; i != end; ++i) f(i);
    });
  };
  for_each(parts, [&](std::size_t i) { std::sort(place(i), place(i + 1), order); });
  for (std::size_t width = 1; width < parts; width *= 2)
    for_each(parts / width / 2, [&](std::size_t i) {
      const std::size_t first = 2 * width * i;
      std::inplace_merge(place(first), place(first + width), place(first + 2 * width), order);
    });
}

}  // namespace tamis
