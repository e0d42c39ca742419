#include "search/engine/step_length_consumer.hpp"

#include <cmath>
#include <limits>

#include "numbers/error_bounds.hpp"
#include "search/engine/pair_buffer.hpp"
#include "search/query/cancellation.hpp"

namespace tamis {
namespace {

float rounded_up(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity()); }

}  // namespace

KeepRule StepLengthQuery::rule() const {
  TAMIS_ASSERT(0 < fraction && fraction < 1);
  const double until = bound.latest() * (1 + 0x1p-15);
  return {rounded_up(fraction), rounded_up(until / (1 - fraction)), rounded_up(until), spread, clearance_bounds(until)};
}

/// A pair can end the step only if (stretch - fraction) clearance <= until residual + advance clearance + (1 - stretch)
/// separation. Without a gradient, only if its speed suffices, by the same bound as in decide().
ClearanceBounds StepLengthQuery::clearance_bounds(double until) const {
  constexpr double kShare = 0.25;  // (x + y + z)^2 <= (1 + kShare) x^2 + 2 (1 + 1 / kShare) (y^2 + z^2)
  const auto& [least, greatest] = shared_motion.stretch;
  const double left = least - fraction, reach = until / left;
  const float stretch2 = rounded_up(greatest * greatest);
  if (!shared_motion.has_gradient) return {rounded_up(reach * reach), 0, 0, stretch2};
  const double per_size = error_bounds::kBoxAdvanceClearance / left;
  const double fixed = (1 - least) * separation / left;
  return {rounded_up((1 + kShare) * reach * reach), rounded_up(4 * (1 + 1 / kShare) * per_size * per_size),
          rounded_up(2 * (1 + 1 / kShare) * fixed * fixed), stretch2};
}

void StepLengthConsumer::begin(StepLengthQuery& shared) {
  PairStream::begin(shared.query);
  shared_ = &shared;
  limit_ = {};
  ends_.clear();
}

void StepLengthConsumer::consume(PairKind kind, PairBuffer& pairs) {
  SearchCounts& counts = thread().counts;
  PairBuffer& near = thread().filtered;
  of(counts.boxes, kind) += static_cast<std::uint64_t>(pairs.count);
  if (limit_.time == 0) keep_wanted(pairs, [&](int i) { return !limit_.rules_out(kind, vertices_of(kind, pairs, i)); });
  leave_out_unchanged(query().changed, kind, pairs);  // costs less than the tests below
  leave_out_groups(query().filter, kind, pairs);
  if (can_cross(kind)) thread().kernels.of(kind).may_end_step(thread().motion.view(), shared_->rule(), pairs, near);
  PairBuffer& left = can_cross(kind) ? near : pairs;  // pairs of loose points are few
  of(counts.near, kind) += static_cast<std::uint64_t>(left.count);
  leave_out(query().filter, kind, left);
  counts.filter += thread().watch.lap();
  for (int i = 0; i < left.count; ++i) decide(kind, vertices_of(kind, left, i));
}

void StepLengthConsumer::decide(PairKind kind, const PairVertices& vertices) {
  stop_if_cancelled(query());
  if (limit_.rules_out(kind, vertices)) return;
  const double earliest = shared_->bound.latest();
  const double until = std::nextafter(earliest, 2.0);  // a tie is of interest too
  const double time = keeps_distance_until(kind, points_of(query().step, vertices),
                                           query().distance_rule_for(kind, vertices, shared_->fraction), until,
                                           thread().counts.decided_by);
  if (time == 1 || time > earliest || query().are_neighbours(kind, vertices)) return;
  if (shared_->lists_all) {
    ends_.push_back({time, kind, vertices});
    return;
  }
  limit_.add({time, kind, vertices});
  shared_->bound.lower(time);
}

}  // namespace tamis
