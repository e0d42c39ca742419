// Sorting by the documented order of contacts.
#pragma once
#include <functional>
#include <vector>

#include "numbers/counting_sort.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// Sorts by kind, then vertices; keeps its scratch memory from call to call. Runs in the caller's arena. Several
/// threads call `pause` now and then. If it throws, sorting ends and the contacts are as before.
class ContactSorter {
 public:
  void sort(std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause);
  std::uint64_t memory_bytes() const { return held_bytes(keys_, counting_, entries_, sorted_); }

 private:
  struct Entry {
    Index v1, v2, v3;
    std::uint32_t place;  ///< of the contact, before sorting
  };
  struct Key {
    std::size_t bucket;  ///< by kind and first vertex
    Entry entry;
  };

  /// Returns how many buckets there are.
  std::size_t make_keys(const std::vector<Contact>& contacts, std::size_t vertex_count,
                        const std::function<void()>& pause);

  std::vector<Key> keys_;
  CountingSort counting_;
  std::vector<Entry> entries_;  ///< in the order of their buckets
  std::vector<Contact> sorted_;
};

}  // namespace tamis
