// Answers for many pairs, one by one, while Python may want to stop.
#pragma once
#include <type_traits>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/signals.hpp"

namespace tamis::python {

/// The bytes of `decide(i)` for each i below `count`; the lock is free meanwhile.
template <class Decide>
nb::object decide_each(std::size_t count, const Decide& decide) {
  std::vector<std::invoke_result_t<Decide, std::size_t>> results(count);
  Signals signals;
  signals.begin();
  {
    const nb::gil_scoped_release unlocked;
    constexpr std::size_t kBatch = 256;  // between two looks at the clock
    for (std::size_t i = 0; i < count; ++i) {
      if (i % kBatch == 0 && signals.ask()) break;
      results[i] = decide(i);
    }
  }
  signals.rethrow();
  return own_bytes(std::move(results));
}

}  // namespace tamis::python
