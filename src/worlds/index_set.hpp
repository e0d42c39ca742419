// A set of indices below a fixed count, such as the numbers of a body's items.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "numbers/assert.hpp"
#include "numbers/held_bytes.hpp"
#include "search/topology/at.hpp"
#include "tamis/mesh.hpp"

namespace tamis {

class IndexSet {
 public:
  /// Empty. Indices are below `count`.
  explicit IndexSet(Index count) : words_((at(count) + kBits - 1) / kBits) {}

  bool has(Index index) const { return words_[at(index) / kBits] >> (at(index) % kBits) & 1; }
  bool has_all(std::span<const Index> indices) const {
    return std::ranges::all_of(indices, [this](Index index) { return has(index); });
  }
  /// REQUIRES: both sets have the same `count`.
  bool includes(const IndexSet& other) const {
    TAMIS_ASSERT(words_.size() == other.words_.size());
    return std::ranges::equal(words_, other.words_,
                              [](std::uint64_t mine, std::uint64_t theirs) { return (theirs & ~mine) == 0; });
  }
  void add(Index index) { words_[at(index) / kBits] |= std::uint64_t{1} << (at(index) % kBits); }
  std::size_t size() const {
    std::size_t size = 0;
    for (const std::uint64_t word : words_) size += static_cast<std::size_t>(std::popcount(word));
    return size;
  }
  /// Calls f(index), ascending.
  template <class F>
  void for_each(const F& f) const {
    for (std::size_t w = 0; w < words_.size(); ++w)
      for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
        f(static_cast<Index>(w * kBits + static_cast<std::size_t>(std::countr_zero(left))));
  }
  std::uint64_t memory_bytes() const { return held_bytes(words_); }

 private:
  static constexpr std::size_t kBits = 64;

  std::vector<std::uint64_t> words_;
};

}  // namespace tamis
