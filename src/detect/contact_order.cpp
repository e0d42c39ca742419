#include "detect/contact_order.hpp"

#include <algorithm>
#include <tuple>

#include "numerics/assert.hpp"
#include "numerics/in_parts.hpp"
#include "query/contact_collector.hpp"
#include "topology/at.hpp"

namespace tamis {
namespace {

/// Between two calls of `pause`: well below a millisecond.
constexpr std::size_t kContactsPerPause = std::size_t{1} << 14;
/// With fewer contacts the buckets would be most of the work.
constexpr std::size_t kVerticesPerContact = 64;

/// Calls f(i) for all i below `count`, in order, and `pause` now and then.
template <class F>
void for_each_place(std::size_t count, const std::function<void()>& pause, const F& f) {
  for (std::size_t first = 0; first < count; first += kContactsPerPause) {
    pause();
    const std::size_t end = std::min(count, first + kContactsPerPause);
    for (std::size_t i = first; i < end; ++i) f(i);
  }
}

}  // namespace

/// A counting sort into one bucket a kind and first vertex, then each small bucket by the other vertices, which lie
/// together with the contact's place: contacts are looked at once and moved once.
void ContactSorter::sort(std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause) {
  if (contacts.size() < at(vertex_count) / kVerticesPerContact)
    return std::sort(contacts.begin(), contacts.end(), comes_before);
  fill_buckets(contacts, vertex_count, pause);
  const std::size_t buckets = first_.size() - 2;
  const auto is_before = [&](const Entry& a, const Entry& b) {
    const auto key = [](const Entry& e) { return std::tie(e.v1, e.v2, e.v3); };
    return key(a) != key(b) ? key(a) < key(b) : comes_before(contacts[a.place], contacts[b.place]);
  };
  sorted_.resize(contacts.size());
  constexpr std::size_t kGrain = 2048;
  in_parts(buckets, kGrain, [&](std::size_t first_bucket, std::size_t end_bucket) {
    pause();
    const auto begin = entries_.begin();
    for (std::size_t b = first_bucket; b != end_bucket; ++b)
      if (first_[b + 1] > first_[b] + 1) std::sort(begin + first_[b], begin + first_[b + 1], is_before);
    constexpr std::uint32_t kFetched = 8;          // contacts lie scattered
    const std::uint32_t end = first_[end_bucket];  // what is behind it may be being sorted
    for (std::uint32_t i = first_[first_bucket]; i < end; ++i) {
      if (i + kFetched < end) __builtin_prefetch(&contacts[entries_[i + kFetched].place]);
      sorted_[i] = contacts[entries_[i].place];
    }
  });
  contacts.swap(sorted_);
}

void ContactSorter::fill_buckets(const std::vector<Contact>& contacts, Index vertex_count,
                                 const std::function<void()>& pause) {
  std::size_t kinds = 0;
  for_each_place(contacts.size(), pause,
                 [&](std::size_t i) { kinds = std::max(kinds, static_cast<std::size_t>(contacts[i].kind) + 1); });
  const auto buckets = kinds * at(vertex_count);
  const auto bucket_of = [&](const Contact& c) {
    TAMIS_ASSERT(0 <= c.vertices[0] && c.vertices[0] < vertex_count);
    return static_cast<std::size_t>(c.kind) * at(vertex_count) + at(c.vertices[0]);
  };
  first_.assign(buckets + 2, 0);
  for_each_place(contacts.size(), pause, [&](std::size_t i) { ++first_[bucket_of(contacts[i]) + 2]; });
  for (std::size_t b = 2; b < first_.size(); ++b) first_[b] += first_[b - 1];
  entries_.resize(contacts.size());
  for_each_place(contacts.size(), pause, [&](std::size_t i) {
    const Contact& c = contacts[i];
    entries_[first_[bucket_of(c) + 1]++] = {c.vertices[1], c.vertices[2], c.vertices[3], static_cast<std::uint32_t>(i)};
  });
}

}  // namespace tamis
