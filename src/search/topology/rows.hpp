// Compressed rows of indices, and how they are built: by counting.
#pragma once
#include <numeric>
#include <span>
#include <vector>

#include "search/topology/at.hpp"

namespace tamis {

/// Compressed rows: row i is `items[offsets[i] .. offsets[i+1])`.
struct IndexRows {
  std::vector<Index> offsets{0};
  std::vector<Index> items;

  std::span<const Index> operator[](Index row) const {
    const auto first = at(offsets[at(row)]), last = at(offsets[at(row) + 1]);
    return std::span(items).subspan(first, last - first);
  }
  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
};

/// `for_each(add)`, called twice, calls add(row, item) for each item. A row has its items in the order of these calls.
/// REQUIRES (not checked: O(n)): rows in [0, count), fewer than 2^31 items.
template <class ForEach>
IndexRows rows_of(Index count, const ForEach& for_each) {
  IndexRows rows;
  rows.offsets.assign(at(count) + 1, 0);
  for_each([&](Index row, Index) { ++rows.offsets[at(row) + 1]; });
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.items.resize(at(rows.offsets.back()));
  std::vector<Index> next(rows.offsets.begin(), rows.offsets.end() - 1);
  for_each([&](Index row, Index item) { rows.items[at(next[at(row)]++)] = item; });
  return rows;
}

}  // namespace tamis
