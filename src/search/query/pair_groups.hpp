// Tells whether two vertices may touch, by their groups.
#pragma once
#include "numbers/assert.hpp"
#include "tamis/options.hpp"

namespace tamis {

/// True if there are groups that may not touch.
inline bool has_groups(const PairFilter& filter) { return !filter.groups_may_touch.empty(); }

/// True if the groups of two vertices may touch. REQUIRES: has_groups; vertices that have a group, groups that there
/// are.
inline bool may_touch(const PairFilter& filter, Index a, Index b) {
  TAMIS_ASSERT(has_groups(filter));
  const auto group = [&](Index v) {
    TAMIS_ASSERT(static_cast<std::size_t>(v) < filter.group_of_vertex.size());
    const Index g = filter.group_of_vertex[static_cast<std::size_t>(v)];
    TAMIS_ASSERT(0 <= g && g < filter.group_count);
    return static_cast<std::size_t>(g);
  };
  return filter.groups_may_touch[group(a) * static_cast<std::size_t>(filter.group_count) + group(b)] != 0;
}

}  // namespace tamis
