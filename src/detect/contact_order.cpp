#include "detect/contact_order.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

namespace tamis {

bool comes_before(const Contact& a, const Contact& b) {
  return std::tie(a.kind, a.vertices, a.toi_lower, a.toi_upper) <
         std::tie(b.kind, b.vertices, b.toi_lower, b.toi_upper);
}

/// A counting sort into one bucket a kind and first vertex, then each small bucket by comparison: contacts are moved
/// once.
void ContactSorter::sort(std::vector<Contact>& contacts, Index vertex_count) {
  const auto buckets = 2 * static_cast<std::size_t>(vertex_count);
  const auto bucket_of = [&](const Contact& c) {
    return static_cast<std::size_t>(c.vertices[0]) + (c.kind == PairKind::edge_edge ? buckets / 2 : 0);
  };
  first_.assign(buckets + 2, 0);
  for (const Contact& c : contacts) ++first_[bucket_of(c) + 2];
  for (std::size_t b = 2; b < first_.size(); ++b) first_[b] += first_[b - 1];
  order_.resize(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    order_[first_[bucket_of(contacts[i]) + 1]++] = static_cast<std::uint32_t>(i);
  sorted_.resize(contacts.size());
  constexpr std::size_t kGrain = 2048;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, buckets, kGrain), [&](const auto& range) {
    for (std::size_t b = range.begin(); b != range.end(); ++b) {
      const auto begin = order_.begin() + first_[b], end = order_.begin() + first_[b + 1];
      std::sort(begin, end, [&](auto i, auto j) { return comes_before(contacts[i], contacts[j]); });
      for (std::uint32_t i = first_[b]; i < first_[b + 1]; ++i) sorted_[i] = contacts[order_[i]];
    }
  });
  contacts.swap(sorted_);
}

}  // namespace tamis
