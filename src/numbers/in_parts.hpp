// Parallel loops, if they are long enough.
#pragma once
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <span>

#include "numbers/floating_point_state.hpp"

namespace tamis {

/// Vertices in a part of a loop that does little with each of them. A part takes ten to twenty microseconds.
inline constexpr std::size_t kVerticesPerPart = 1024;

inline bool has_other_threads() { return tbb::this_task_arena::max_concurrency() > 1; }

/// Calls f(begin, end) for parts of 0 to `count`. A loop no longer than `grain` stays with this thread. Handing it over
/// costs a tenth of a whole question about a mesh of a dozen triangles. Without other threads, parts are sixteen times
/// as long. They are short enough that a check for cancellation between them runs often, and so few that they cost
/// nothing.
template <class Count, class F>
void in_parts(Count count, Count grain, const F& f) {
  if (count > grain && has_other_threads())
    return tbb::parallel_for(tbb::blocked_range<Count>(0, count, static_cast<std::size_t>(grain)),
                             as_task([&](const tbb::blocked_range<Count>& part) { f(part.begin(), part.end()); }));
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
/// the loop is parted. `nothing`: the value of no items. join(a, b): the value of both parts.
template <class Value, class Join, class F>
Value joined_parts(std::size_t count, std::size_t grain, const Value& nothing, const Join& join, const F& f) {
  if (count > grain && has_other_threads()) {
    using Range = tbb::blocked_range<std::size_t>;
    return tbb::parallel_reduce(Range(0, count, grain), nothing, as_task([&](const Range& part, const Value& before) {
                                  return join(before, f(part.begin(), part.end()));
                                }),
                                as_task(join));
  }
  Value value = nothing;
  in_parts(count, grain, [&](std::size_t begin, std::size_t end) { value = join(value, f(begin, end)); });
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
  return [&comes_before, pause_in_task = as_task(pause)](const auto& a, const auto& b) {
    constexpr unsigned kComparisonsPerPause = 1U << 14;  // below a millisecond
    static thread_local unsigned compared = 0;
    if (++compared % kComparisonsPerPause == 0) pause_in_task();
    return comes_before(a, b);
  };
}

/// Sorts by a total order. Only equal items are neither before nor after each other. REQUIRES (not checked: O(n)): an
/// order of integers, for which the state of floating-point numbers does not matter. `pause`: as in pausing(). Without
/// other threads, std::sort is faster than oneTBB's sort.
template <class Items, class Order, class Pause>
void sort_in_parts(Items& items, const Order& comes_before, const Pause& pause) {
  const auto order = pausing(comes_before, pause);
  if (has_other_threads())
    tbb::parallel_sort(items, order);
  else
    std::sort(items.begin(), items.end(), order);
}

}  // namespace tamis
