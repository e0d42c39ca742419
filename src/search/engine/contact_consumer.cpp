#include "search/engine/contact_consumer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "pair/narrow/contact_normal.hpp"
#include "pair/narrow/decide.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/engine/stages.hpp"
#include "search/query/cancellation.hpp"

namespace tamis {

void ContactConsumer::consume(PairKind kind) {
  leave_out_unwanted(kind);
  const bool by_distance = thread().motion.separations.any() || !can_cross(kind);
  if (query().depends_on_pair_alone && !by_distance) return decide_as_list(kind);
  const int count = by_distance ? decide_within_separation(thread(), kind, found_.bound().latest())
                                : decide_crossings(thread(), kind, thread().kernels.of(kind));
  const PairBuffer& pairs = thread().filtered;
  decide_left(kind, add_solved(thread(), count, [&](int i, const PairResult& result) {
                add(kind, vertices_of(kind, pairs, i), result);
              }));
}

void ContactConsumer::decide_as_list(PairKind kind) {
  if (!list_scratch_) {
    list_scratch_ = std::make_unique<ListScratch>();
    std::iota(list_scratch_->places.begin(), list_scratch_->places.end(), 0);
  }
  const PairKernels& kernels = thread().kernels.of(kind);
  filter_crossings(thread(), kind, kernels);
  const PairBuffer& pairs = thread().filtered;
  const auto& [start, end] = query().step;
  const StepRows vertices{start.data(), end.data(), start.stride(), end.stride()};
  auto& [places, undecided, results] = *list_scratch_;
  const int count =
      kernels.decide_list({vertices, places.data()}, pairs, thread().clipped, results.data(), undecided.data());
  thread().counts.decided_by.lanes += static_cast<std::uint64_t>(pairs.count - count);
  const auto left = std::span<const int>(undecided).first(static_cast<std::size_t>(count));
  for (const int pair : left) results[static_cast<std::size_t>(pair)] = {};
  decide_left(kind, left);
  for (int i = 0; i < pairs.count; ++i)
    found_.add(kind, vertices_of(kind, pairs, i), results[static_cast<std::size_t>(i)], DecidedBy::doubles);
}

void ContactConsumer::leave_out_unwanted(PairKind kind) {
  PairBuffer& pairs = thread().boxes;
  if (!found_.wants(kind)) pairs.count = 0;
  if (query().each_of) shorten_times(kind);
  if (found_.is_choosy()) keep_wanted(pairs, [&](int i) { return found_.wants(kind, vertices_of(kind, pairs, i)); });
  leave_out(query().filter, kind, pairs);
}

void ContactConsumer::shorten_times(PairKind kind) {
  PairBuffer& pairs = thread().boxes;
  for (int i = 0; i < pairs.count; ++i) {
    const double latest = found_.latest(kind, vertices_of(kind, pairs, i));
    pairs.t_out[i] = std::min(pairs.t_out[i], float_after(std::max(latest, 0.0)));
  }
}

/// Adds a contact that lanes found, whose place they may have left to integers.
void ContactConsumer::add(PairKind kind, const PairVertices& vertices, PairResult result) {
  if (std::isnan(result.normal[0])) {
    if (!found_.wants(kind, vertices)) return;
    set_place(result, exact_closest_place(kind, points_of(query().step, vertices), result.toi_lower));
  }
  found_.add(kind, vertices, result, query().depends_on_pair_alone ? DecidedBy::doubles : DecidedBy::lanes);
}

void ContactConsumer::decide_left(PairKind kind, std::span<const int> places) {
  const auto vertices_at = [&, &pairs = thread().filtered](int place) { return vertices_of(kind, pairs, place); };
  const auto wants_it = [&, &pairs = thread().filtered](int place) {
    return found_.wants(kind, vertices_at(place), pairs.t_in[place]);
  };
  const bool is_earliest = query().question == Question::earliest;
  const auto decided = [&](int place, PrecisionCount& counts) {
    stop_if_cancelled(query());
    const PairVertices vertices = vertices_at(place);
    const double separation = query().separations.between(kind, vertices);
    OfInterest times;
    if (is_earliest) times = found_.of_interest(kind, vertices);
    return decide({kind, points_of(query().step, vertices), separation}, counts, times);
  };
  decide_singly(thread(), places, query().question == Question::all_contacts, wants_it, decided,
                [&](int place, const DecidedPair& pair) {
                  found_.add(kind, vertices_at(place), pair.result,
                             pair.by_integers ? DecidedBy::integers : DecidedBy::doubles);
                });
}

}  // namespace tamis
