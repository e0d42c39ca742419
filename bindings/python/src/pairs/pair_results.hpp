// Answers for many pairs, one by one, while Python may want to stop.
#pragma once
#include <functional>
#include <type_traits>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/signals.hpp"

namespace tamis::python {

/// The bytes of `decide(i, is_cancelled)` for each i below `count`; the lock is free meanwhile.
template <class Decide>
nb::object decide_each(std::size_t count, const Decide& decide) {
  Signals signals;
  const std::function<bool()> is_cancelled = [&] { return signals.ask(); };
  std::vector<std::invoke_result_t<Decide, std::size_t, decltype(is_cancelled)>> results(count);
  signals.during([&] {
    constexpr std::size_t kBatch = 256;  // between two looks at the clock
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kBatch == 0 && signals.ask()) throw Cancelled("the list was interrupted");
      results[i] = decide(i, is_cancelled);
    }
  });
  return own_bytes(std::move(results));
}

}  // namespace tamis::python
