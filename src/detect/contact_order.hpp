// Sorting by the documented order of contacts.
#pragma once
#include <functional>
#include <vector>

#include "numerics/held_bytes.hpp"
#include "tamis/contact.hpp"

namespace tamis {

/// By kind, then vertices; keeps its scratch memory from call to call. Runs in the caller's oneTBB arena. What `pause`,
/// called now and then and by several threads, throws ends it: the contacts are then as they were.
class ContactSorter {
 public:
  void sort(std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause);
  std::uint64_t memory_bytes() const { return held_bytes(first_, entries_, sorted_); }

 private:
  struct Entry {
    Index v1, v2, v3;
    std::uint32_t place;  ///< of the contact, before sorting
  };

  /// Counts, then places each contact in its bucket: of bucket b they are entries_[first_[b], first_[b + 1]).
  void fill_buckets(const std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause);

  std::vector<std::uint32_t> first_;  ///< of each bucket: kind and first vertex
  std::vector<Entry> entries_;
  std::vector<Contact> sorted_;
};

}  // namespace tamis
