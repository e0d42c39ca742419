// How a question ends before its answer: cancellation is checked before each batch of pairs, and before each pair that
// is decided by itself, which can take milliseconds.
#pragma once
#include "query/isolated.hpp"
#include "tamis/error.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// Throws Cancelled once the caller wants no answer any more. Options, those of a list of pairs, or of its parts.
template <class AnyOptions>
void stop_if_cancelled(const AnyOptions& options) {
  if (options.is_cancelled && isolated(options.is_cancelled))
    throw Cancelled("the question was cancelled: ask it again");
}

}  // namespace tamis
