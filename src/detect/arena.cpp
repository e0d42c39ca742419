#include "detect/arena.hpp"

#include <tbb/global_control.h>

#include <algorithm>

namespace tamis {
namespace {

/// The most threads to ask oneTBB for: beyond these it warns on stderr, and a million exhausts its memory.
int most_threads() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace

Arena::Arena(int threads) : is_own_(threads > 0) {
  if (is_own_) arena_.initialize(std::min(threads, most_threads()));
}

}  // namespace tamis
