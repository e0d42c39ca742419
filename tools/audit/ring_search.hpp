// How far apart two features are on their mesh: the number of edges on the shortest path between them.
#pragma once
#include <span>
#include <vector>

#include "audit/findings.hpp"

namespace tamis::audit {

/// Breadth-first from one feature, no farther than a limit. Successive pairs with the same first feature share one
/// search; every answer lists its pairs in such an order.
class RingSearch {
 public:
  RingSearch(const AuditedMesh& mesh, Index limit);

  /// 0 with a common vertex, 1 if one edge joins them, and so on; limit + 1 if the shortest path is longer than the
  /// limit; kNotConnected if there is none.
  Index between(std::span<const Index> first, std::span<const Index> second);

 private:
  void search_from(std::span<const Index> feature);
  void reach(Index vertex, Index rings);
  Index rings_to(Index vertex) const;

  const AuditedMesh& mesh_;
  Index limit_;
  std::vector<Index> from_;     ///< the feature that was searched from
  std::vector<Index> reached_;  ///< vertices within the limit of it, by their distance
  std::vector<Index> rings_;    ///< one a vertex; kUnreached beyond the limit
};

}  // namespace tamis::audit
