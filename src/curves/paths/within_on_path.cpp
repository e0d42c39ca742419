#include <algorithm>
#include <cmath>

#include "curves/paths/chords.hpp"
#include "curves/paths/first_on_path.hpp"
#include "curves/paths/path_parts.hpp"
#include "numbers/assert.hpp"
#include "numbers/error_bounds.hpp"
#include "pair/narrow/first_within.hpp"

namespace tamis {
namespace {

constexpr int kMostPartsWithin = 1 << 16;
/// The share of a part's rest that is tested next, once the chords are no longer proven apart.
constexpr double kNext = 0x1p-5;

/// The largest deviation and error that two points, one of each feature, can have together.
double slack_of(const PathPart<double>& part) {
  const double deviation = *std::ranges::max_element(part.deviations);
  return (2 * deviation + position_slack(std::max(part.from.error, part.to.error))) * kRoundedUp;
}

bool axis_proves_free(PairKind kind, const PathPart<double>& part, const StraightDirections& directions,
                      double separation) {
  return with_kind(kind, [&](auto k) {
    const Chords<k(), double> chords(part.from, part.to, part.deviations, directions);
    return chords.axis_proves_free(chords.at_ends(), separation);
  });
}

/// True if at one time the distance is certainly within the separation.
bool touches_at(PairKind kind, const Moment<double>& moment, double separation) {
  const double allowed = separation - position_slack(moment.error);
  if (!(allowed > 0)) return false;
  const auto m = make_motion(kind, points_between(moment, moment), allowed);
  return first_within(kind, m, {0, 1}).touches();
}

}  // namespace

bool is_apart_at(PairKind kind, const Moment<double>& moment, double separation) {
  const double beyond = (separation + position_slack(moment.error)) * kRoundedUp;
  return first_within(kind, make_motion(kind, points_between(moment, moment), beyond), {0, 1}).is_free();
}

Decision first_within_on_path(const PathQuestion& question, const PairReader& reader,
                              const TimeInterval<double>& time) {
  TAMIS_ASSERT(question.min_separation > 0 && is_part_of_step(time));
  const PairKind kind = question.kind;
  const double separation = question.min_separation * reader.scale();
  PathParts<double> parts(question, reader, time);
  while (auto part = parts.next()) {
    const double from = part->from.time, to = part->to.time;
    if (axis_proves_free(kind, *part, reader.directions(), separation)) continue;
    const auto m = make_motion(kind, points_between(part->from, part->to), separation + slack_of(*part));
    const Decision chords = first_within(kind, m, {0, 1});
    if (chords.is_free()) continue;
    const double reached = from + chords.lower * (to - from) * (1 - 0x1p-50) - 0x1p-52 * to;
    const double lower = std::clamp(reached, from, std::nextafter(to, 0.0));
    if (to - lower <= question.tolerance && touches_at(kind, part->to, separation))
      return {Verdict::touches, lower, to};
    const double next = lower + kNext * (to - lower);
    const bool is_short = to - from <= 0x1p-50 * to || to - from < 0x1p-100 || !(next > lower);
    if (is_short || parts.taken() > kMostPartsWithin) return {Verdict::unsure, lower, to};
    parts.cut({lower > from ? reader.at<double>(lower) : part->from, part->to}, next);
  }
  return {};
}

}  // namespace tamis
