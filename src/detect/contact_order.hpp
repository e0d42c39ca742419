// Sorting by the documented order of contacts.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "query/pair_sorter.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// By kind, then vertices; keeps its scratch memory from call to call. Runs in the caller's oneTBB arena. What `pause`,
/// called now and then and by several threads, throws ends it: the contacts are then as they were.
class ContactSorter {
 public:
  void sort(std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause);
  std::uint64_t memory_bytes() const { return held_bytes(keys_, sorter_, sorted_); }

 private:
  /// Sorted in place of the contact, which is looked at once and moved once.
  struct Key : PairVertices {
    std::uint32_t place;  ///< of the contact
  };

  std::array<std::vector<Key>, kPairKinds> keys_;
  PairSorter<Key> sorter_;
  std::vector<Contact> sorted_;
};

}  // namespace tamis
