// How long no lists are made after lists that cost more than they saved.
#pragma once
#include <algorithm>
#include <utility>

namespace tamis {

/// Each pause is twice as long as the one before, up to kLongest; lists that were worth it make the next one short
/// again.
struct ListingPause {
  static constexpr int kLongest = 64;
  int first, next = first, left = 0;

  void begin() { left = std::exchange(next, std::min(2 * next, kLongest)); }
  void tick() { left = std::max(0, left - 1); }
  void lists_were_worth_it() { next = first; }
};

}  // namespace tamis
