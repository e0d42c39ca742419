// Answers of several detectors, each in order, as one in order.
#pragma once
#include <algorithm>
#include <vector>

#include "numerics/assert.hpp"
#include "world/named_pairs.hpp"

namespace tamis {

/// In the order of is_before().
template <class Row>
class OrderedParts {
 public:
  void add(const Row& row) { rows_.push_back(row); }
  /// REQUIRES: what was added since the last end is in order.
  void end_part() {
    TAMIS_ASSERT(std::is_sorted(at(ends_.empty() ? 0 : ends_.back()), rows_.end(), is_row_before));
    ends_.push_back(rows_.size());
  }
  /// Neighbours are merged until one is left.
  std::vector<Row> merged() && {
    while (ends_.size() > 1) {
      std::vector<std::size_t> ends;
      std::size_t first = 0;
      for (std::size_t i = 0; i < ends_.size(); i += 2) {
        const std::size_t last = ends_[std::min(i + 1, ends_.size() - 1)];
        std::inplace_merge(at(first), at(ends_[i]), at(last), is_row_before);
        ends.push_back(first = last);
      }
      ends_ = std::move(ends);
    }
    return std::move(rows_);
  }

 private:
  static bool is_row_before(const Row& a, const Row& b) { return is_before(a, b); }
  typename std::vector<Row>::iterator at(std::size_t i) { return rows_.begin() + static_cast<std::ptrdiff_t>(i); }

  std::vector<Row> rows_;
  std::vector<std::size_t> ends_;  ///< of parts
};

}  // namespace tamis
