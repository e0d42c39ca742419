// Cancellation is checked before each batch of pairs, and before each pair that is decided singly. Such a pair can take
// milliseconds.
#pragma once
#include "numbers/parallel.hpp"
#include "tamis/error.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// Throws Cancelled if the caller's is_cancelled returns true. `options`: anything with that member.
template <class AnyOptions>
void stop_if_cancelled(const AnyOptions& options) {
  if (options.is_cancelled && of_caller(options.is_cancelled)) throw Cancelled("the question was cancelled: repeat it");
}

}  // namespace tamis
