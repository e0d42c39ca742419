#include "search/query/what_counts.hpp"

#include "pair/narrow/decide.hpp"

namespace tamis {

bool add_what_counts(ContactCollector& found, PairKind kind, const PairVertices& vertices, const PairResult& result,
                     PrecisionCount& decided_by, bool by_integers) {
  const Query& query = found.query();
  const bool is_ignored = query.ignores_start && result.touches && result.toi_upper == 0;
  if (!is_ignored) return found.add(kind, vertices, result, by_integers);
  if (query.are_neighbours(kind, vertices)) return false;
  const double separation = query.separations.between(kind, vertices);
  const PairResult again = decide_recontact({kind, points_of(query.step, vertices), separation}, decided_by);
  if (again.touches) return found.add(kind, vertices, again, by_integers);
  found.count_ignored();
  return false;
}

}  // namespace tamis
