#include "curves/paths/decide_path.hpp"

#include <algorithm>

#include "curves/paths/chords.hpp"
#include "curves/paths/first_on_path.hpp"
#include "numbers/assert.hpp"
#include "pair/narrow/contact_normal.hpp"

namespace tamis {
namespace {

/// The sign of the pair's coplanarity at a moment. Doubles compute it. Where they cannot tell, double-double does, at
/// ten times the cost. 0: neither can tell.
int side_at(PairKind kind, const PairReader& reader, const Moment<double>& moment) {
  return with_kind(kind, [&](auto k) {
    const auto known_side = [&]<class T>(const Moment<T>& at) {
      const auto ends = Chords<k(), T>(at, at, {}).at_ends();
      return side_of(ends.e.at0, ends.f.at0, ends.d.at0);
    };
    const int side = known_side(moment);
    return side != 0 ? side : known_side(reader.at<DoubleDouble>(moment.time));
  });
}

/// The place on the chords between the bracket's ends. The side on which the pair begins comes from the path itself.
ContactPlace place_on_path(const PathQuestion& question, const Decision& decision) {
  const PairKind kind = question.kind;
  const PairReader reader(question.path, question.vertices, decision.lower);
  const auto start = reader.at<double>(decision.lower);
  const PairPoints points = points_between(start, reader.at<double>(decision.upper));
  const PairInStep chord(kind, points);
  if (is_about_distance(kind, question.min_separation)) return closest_place(chord, 0);
  const int side = side_at(kind, reader, start);
  return crossing_place(chord, {0, 1}, kind == PairKind::edge_edge ? -side : side);
}

/// True if the pair is proven apart at this time.
bool is_apart_on_path(const PathQuestion& question, double time) {
  const PairReader reader(question.path, question.vertices, time);
  const auto moment = reader.at<double>(time);
  if (question.min_separation > 0) return is_apart_at(question.kind, moment, question.min_separation * reader.scale());
  const std::array<double, 4> deviations{};
  return with_kind(question.kind, [&](auto kind) {
    const Chords<kind(), double> chords(moment, moment, deviations);
    return chords.axis_proves_free(chords.at_ends());
  });
}

}  // namespace

Decision decide_on_path(const PathQuestion& question, const TimeInterval<double>& time) {
  TAMIS_ASSERT(is_kind(question.kind) && is_part_of_step(time));
  const PairReader reader(question.path, question.vertices, time.t_in);
  if (question.min_separation > 0) return first_within_on_path(question, reader, time);
  return first_crossing_on_path(question, reader, time);
}

std::optional<Decision> decide_recontact_on_path(const PathQuestion& question, const TimeInterval<double>& time) {
  const double length = time.t_out - time.t_in;
  for (double part = 0x1p-20; part < 1; part = part < 0x1p-4 ? 2 * part : part + 0x1p-4)
    if (const double from = time.t_in + part * length; is_apart_on_path(question, from))
      return decide_on_path(question, {from, time.t_out});
  return std::nullopt;
}

KeptSeparation kept_separation(const Path& path, PairKind kind, const PairVertices& vertices,
                               const DistanceRule& rule) {
  const PairReader reader(path, vertices, 0);
  const auto moment = reader.at<double>(0);
  const PairPoints points = points_between(moment, moment);
  const DistanceBounds middles = start_distance_bounds(kind, points);
  const double slack = position_slack(moment.error), separation = rule.min_separation * reader.scale();
  const double low = (middles.low - slack) * (1 - 0x1p-50), high = (middles.high + slack) * (1 + 0x1p-50);
  const auto kept = [&](double distance) {
    return (separation + rule.fraction * std::max(distance - separation, 0.0)) / reader.scale();
  };
  return {kept(low) * (1 - 0x1p-50), kept(high) * (1 + 0x1p-50) + 0x1p-1000, !(low > separation)};
}

PairResult result_on_path(const PathQuestion& question, const Decision& decision) {
  PairResult result;
  if (decision.is_free()) return result;
  result.touches = true;
  result.certainty = decision.touches() ? Certainty::certified : Certainty::unresolved;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  set_place(result, place_on_path(question, decision));
  return result;
}

}  // namespace tamis
