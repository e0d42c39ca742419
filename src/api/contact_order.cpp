#include "api/contact_order.hpp"

#include <algorithm>
#include <tuple>

#include "numbers/in_parts.hpp"
#include "numbers/platform.hpp"
#include "search/query/contact_collector.hpp"
#include "search/topology/at.hpp"

namespace tamis {
namespace {

/// With at most one contact for so many vertices, the buckets would be most of the work.
constexpr std::size_t kVerticesPerContact = 64;
/// The parts of loops that threads share: each takes well below a millisecond.
constexpr std::size_t kContactsPerPart = 4096, kBucketsPerPart = 512;

}  // namespace

/// A counting sort into one bucket for each kind and first vertex. Then each small bucket is sorted by the other
/// vertices. Entries hold these vertices and the contact's place. So contacts are read once and moved once.
void ContactSorter::sort(std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause) {
  if (contacts.size() <= at(vertex_count) / kVerticesPerContact)
    return std::sort(contacts.begin(), contacts.end(), comes_before);
  const std::size_t buckets = make_keys(contacts, at(vertex_count), pause);
  entries_.resize(contacts.size());
  counting_.find_places(
      contacts.size(), buckets, [&](std::size_t i) { return keys_[i].bucket; },
      [&](std::size_t i, std::size_t place) { entries_[place] = keys_[i].entry; }, pause);
  const auto is_before = [&](const Entry& a, const Entry& b) {
    const auto key = [](const Entry& e) { return std::tie(e.v1, e.v2, e.v3); };
    return key(a) != key(b) ? key(a) < key(b) : comes_before(contacts[a.place], contacts[b.place]);
  };
  sorted_.resize(contacts.size());
  in_parts(buckets, kBucketsPerPart, [&](std::size_t first_bucket, std::size_t end_bucket) {
    pause();
    Entry* const begin = entries_.data();
    for (std::size_t b = first_bucket; b != end_bucket; ++b)
      if (counting_.end_of(b) > counting_.begin_of(b) + 1)
        std::sort(begin + counting_.begin_of(b), begin + counting_.end_of(b), is_before);
    constexpr std::uint32_t kFetched = 8;                        // contacts ahead: they lie scattered
    const std::uint32_t end = counting_.end_of(end_bucket - 1);  // another thread may be sorting entries behind it
    for (std::uint32_t i = counting_.begin_of(first_bucket); i < end; ++i) {
      if (i + kFetched < end) prefetch(&contacts[entries_[i + kFetched].place]);
      sorted_[i] = contacts[entries_[i].place];
    }
  });
  contacts.swap(sorted_);
}

std::size_t ContactSorter::make_keys(const std::vector<Contact>& contacts, std::size_t vertex_count,
                                     const std::function<void()>& pause) {
  keys_.resize(contacts.size());
  const auto make_part = [&](std::size_t first, std::size_t end) {
    pause();
    std::size_t kinds = 0;
    for (std::size_t i = first; i < end; ++i) {
      const auto& v = contacts[i].vertices;
      const auto kind = static_cast<std::size_t>(contacts[i].kind);
      keys_[i] = {kind * vertex_count + at(v[0]), {v[1], v[2], v[3], static_cast<std::uint32_t>(i)}};
      kinds = std::max(kinds, kind + 1);
    }
    return kinds;
  };
  const auto larger = [](std::size_t a, std::size_t b) { return std::max(a, b); };
  return vertex_count * joined_parts(contacts.size(), kContactsPerPart, std::size_t{0}, larger, make_part);
}

}  // namespace tamis
