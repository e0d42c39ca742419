#include "search/contact_consumer.hpp"

#include "narrow/decide.hpp"
#include "query/cancellation.hpp"
#include "search/pair_buffer.hpp"
#include "search/stages.hpp"

namespace tamis {

void ContactConsumer::consume(PairKind kind) {
  leave_out_unwanted(kind);
  const bool by_distance = thread().motion.separations.any() || !can_cross(kind);
  const int count = by_distance ? decide_within_separation(thread(), kind, found_.bound().latest())
                                : decide_crossings(thread(), kind, thread().kernels.of(kind));
  const PairBuffer& pairs = thread().filtered;
  for_each_solved(
      thread(), count, [&](int i, const PairResult& result) { found_.add(kind, vertices_of(kind, pairs, i), result); },
      [&](int i) { decide_singly(kind, vertices_of(kind, pairs, i)); });
}

void ContactConsumer::leave_out_unwanted(PairKind kind) {
  PairBuffer& pairs = thread().boxes;
  if (!found_.wants(kind)) pairs.count = 0;
  if (found_.touches_at_start())
    keep_wanted(pairs, [&](int i) { return found_.wants(kind, vertices_of(kind, pairs, i)); });
  leave_out(query().filter, kind, pairs);
}

void ContactConsumer::decide_singly(PairKind kind, const PairVertices& vertices) {
  stop_if_cancelled(query());
  if (!found_.wants(kind, vertices)) return;
  found_.add(
      kind, vertices,
      decide(kind, points_of(query().step, vertices), query().rule_for(kind, vertices), thread().counts.decided_by));
}

}  // namespace tamis
