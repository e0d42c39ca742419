// Which items of bodies may come near items of others: two hierarchies walked together, in the frame of the world.
#pragma once
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "world/near_bodies.hpp"

namespace tamis {

/// Some items of one body.
class ItemSet {
 public:
  explicit ItemSet(Index item_count) : words_((static_cast<std::size_t>(item_count) + 63) / 64) {}

  bool has(Index item) const { return words_[word(item)] >> (item % 64) & 1; }
  bool has_all(std::span<const Index> items) const {
    return std::ranges::all_of(items, [this](Index item) { return has(item); });
  }
  void add(Index item) {
    if (has(item)) return;
    words_[word(item)] |= std::uint64_t{1} << (item % 64);
    items_.push_back(item);
  }
  bool includes(const ItemSet& other) const { return has_all(other.items_); }
  /// In no order.
  const std::vector<Index>& items() const { return items_; }
  std::uint64_t memory_bytes() const {
    return words_.capacity() * sizeof(words_[0]) + items_.capacity() * sizeof(Index);
  }

 private:
  static std::size_t word(Index item) { return static_cast<std::size_t>(item) / 64; }

  std::vector<std::uint64_t> words_;
  std::vector<Index> items_;
};

/// Of some bodies.
struct NearItems {
  std::map<BodyId, ItemSet> of_body;
  std::vector<BodyPair> pairs;  ///< of those bodies; ascending

  bool includes(const NearItems& other) const;
  void add(const NearItems& other);
  std::size_t count() const;
  std::uint64_t memory_bytes() const;
};

/// All that may come as near as `reach` says, during the pieces between `times`, of which there is a first and a last.
NearItems find_near_items(const BodyList& bodies, const std::vector<BodyPair>& pairs,
                          const std::function<double(const Body&, const Body&)>& reach,
                          const std::vector<double>& times);

}  // namespace tamis
