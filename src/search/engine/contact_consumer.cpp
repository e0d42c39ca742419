#include "search/engine/contact_consumer.hpp"

#include <algorithm>

#include "pair/narrow/decide.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/engine/stages.hpp"
#include "search/query/cancellation.hpp"
#include "search/query/what_counts.hpp"

namespace tamis {

void ContactConsumer::consume(PairKind kind, PairBuffer& pairs) {
  leave_out_unwanted(kind, pairs);
  const PairKernels& stages = thread().kernels.of(kind);
  const bool by_distance = thread().motion.separations.any() || !can_cross(kind);
  const PairBuffer& left =
      by_distance ? filter_apart(thread(), kind, stages, pairs) : filter_crossings(thread(), kind, stages, pairs);
  const LaneDecisions decisions = decide_in_lanes(thread(), stages, latest(), left);
  for (const TouchingPair& pair : touching(decisions)) add(kind, vertices_of(kind, left, pair.pair), {pair.result});
  decide_left(kind, left, undecided(decisions));
}

void ContactConsumer::leave_out_unwanted(PairKind kind, PairBuffer& pairs) {
  if (!found_.wants(kind)) pairs.count = 0;
  if (query().each_of) shorten_times(kind, pairs);
  if (found_.is_choosy()) keep_wanted(pairs, [&](int i) { return found_.wants(kind, vertices_of(kind, pairs, i)); });
  leave_out(query().filter, kind, pairs);
}

void ContactConsumer::shorten_times(PairKind kind, PairBuffer& pairs) {
  for (int i = 0; i < pairs.count; ++i) {
    const double latest = found_.latest(kind, vertices_of(kind, pairs, i));
    pairs.t_out[i] = std::min(pairs.t_out[i], float_after(std::max(latest, 0.0)));
  }
}

void ContactConsumer::add(PairKind kind, const PairVertices& vertices, const DecidedPair& pair) {
  add_what_counts(found_, kind, vertices, pair.result, thread().counts.decided_by, pair.by_integers);
}

void ContactConsumer::decide_left(PairKind kind, const PairBuffer& pairs, std::span<const std::int32_t> places) {
  const auto wants_it = [&](int place) {
    return found_.wants(kind, vertices_of(kind, pairs, place), pairs.t_in[place]);
  };
  const bool is_earliest = query().question == Question::earliest;
  const auto decided = [&](int place, PrecisionCount& counts) {
    stop_if_cancelled(query());
    const PairVertices vertices = vertices_of(kind, pairs, place);
    const double separation = query().separations.between(kind, vertices);
    OfInterest times;
    if (is_earliest) times = found_.of_interest(kind, vertices);
    return decide({kind, points_of(query().step, vertices), separation}, counts, times);
  };
  decide_singly(thread(), places, query().question == Question::all_contacts, wants_it, decided,
                [&](int place, const DecidedPair& pair) { add(kind, vertices_of(kind, pairs, place), pair); });
}

}  // namespace tamis
