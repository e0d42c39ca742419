#include "detect/arena.hpp"

#include <tbb/global_control.h>

#include <algorithm>

namespace tamis {
namespace {

/// Asked for more, oneTBB warns on stderr, and has no memory for a million.
int most_threads() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace

Arena::Arena(int threads) : is_own_(threads > 0) {
  if (is_own_) arena_.initialize(std::min(threads, most_threads()));
}

}  // namespace tamis
