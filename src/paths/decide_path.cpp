#include "paths/decide_path.hpp"

#include <algorithm>

#include "motion/time_clip.hpp"
#include "narrow/contact_normal.hpp"
#include "numerics/assert.hpp"
#include "paths/crossing_on_path.hpp"
#include "paths/path_parts.hpp"
#include "paths/within_on_path.hpp"

namespace tamis {
namespace {

/// Limits for one pair: parts that are looked at in doubles; in double-double; and in double-double within one part
/// that doubles leave undecided.
constexpr int kMostParts = 1 << 17, kMostFineParts = 1 << 17, kMostWithinPart = 1 << 13;
/// While deviations are larger than errors, cutting makes proofs sharper. Below that it does so only because chords
/// turn less, which counts for parts longer than this.
template <class T>
constexpr double kShortest = 0x1p-6;
template <>
constexpr double kShortest<DoubleDouble> = 0x1p-100;

template <PairKind kind, class T>
class PathSolver {
 public:
  PathSolver(const PathQuestion& question, const PairReader& reader, const TimeInterval<double>& time, int most_parts)
      : question_(question), reader_(reader), parts_(question, reader, time), parts_left_(most_parts) {}

  Decision run() {
    while (const auto part = parts_.next())
      if (const auto decision = decided_by(*part)) return *decision;
    return {};
  }
  int parts_looked_at() const { return parts_.taken(); }

 private:
  /// The final decision: the earliest time that cannot be proven free. Nothing: this part is free, or cut further.
  std::optional<Decision> decided_by(const PathPart<T>& part) {
    const std::array<double, 4> deviations = reader_.deviations(part.from.time, part.to.time);
    const Chords<kind, T> chords(part.from, part.to, deviations, reader_.directions());
    const auto ends = chords.at_ends();
    if (chords.axis_proves_free(ends)) return {};
    const auto widened = chords.motion();
    if (filters_prove_free(widened)) return {};
    if (!std::is_same_v<T, double> && !is_apart_at_start(part))
      return Decision{Verdict::unsure, part.from.time, end_of_shortest(part.from.time, part.to.time)};
    const int side_before = can_cross(kind) ? side_before_crossing(ends) : 0;
    if (side_before != 0) {
      const bool is_narrow = part.length() <= question_.tolerance && part.from.time > 0;
      if (is_narrow && stays_inside<kind>(widened)) return Decision{Verdict::touches, part.from.time, part.to.time};
      if (cut_around_crossing(part, window_of(widened, side_before))) return {};
    }
    if (--parts_left_ > 0 && may_gain(part, deviations, chords.gap_at_start(ends)) &&
        parts_.cut(part, near_middle(part.from.time, part.to.time)))
      return {};
    return decided_further(part, widened, side_before != 0);
  }

  static bool filters_prove_free(const PairMotion<BasicInterval<T>>& m) {
    if constexpr (can_cross(kind))
      return Dnf::proves_free<kind>(m) || Ncf::proves_free<kind>(m);
    else
      return false;
  }

  bool is_apart_at_start(const PathPart<T>& part) const {
    constexpr std::array<double, 4> kNoDeviations{};
    const Chords<kind, T> start(part.from, part.from, kNoDeviations, reader_.directions());
    const auto ends = start.at_ends();
    return start.axis_proves_free(ends) || filters_prove_free(ends);
  }

  /// The end of the first part, if that is cut until it is too short.
  static double end_of_shortest(double from, double to) {
    while (to - from > kShortest<T>) {
      const double middle = near_middle(from, to);
      if (!(from < middle && middle < to)) break;
      to = middle;
    }
    return to;
  }

  /// Does cutting make proofs sharper? Not by doubles where positions are as far off as features are apart.
  bool may_gain(const PathPart<T>& part, const std::array<double, 4>& deviations, double gap_at_start) const {
    const double error = std::max(part.from.error, part.to.error);
    if (std::is_same_v<T, double> && !(gap_at_start > 8 * error)) return false;
    const double deviation = *std::max_element(deviations.begin(), deviations.end());
    return deviation > 4 * error || part.length() > kShortest<T>;
  }

  bool cut_around_crossing(const PathPart<T>& part, const TimeInterval<double>& window) {
    constexpr double kMostOfPart = 0.5;
    if (!(window.t_out - window.t_in <= kMostOfPart)) return false;
    const double from = part.from.time, to = part.to.time, ulp = 0x1p-52 * to;
    const TimeInterval<double> middle{std::max(from + window.t_in * (to - from) - ulp, from),
                                      std::min(from + window.t_out * (to - from) + ulp, to)};
    if (!(middle.t_in < middle.t_out && middle.t_out - middle.t_in <= kMostOfPart * part.length())) return false;
    parts_.cut(part, middle);
    return true;
  }

  /// Where cutting helps this arithmetic no more: doubles ask double-double, which has the last word.
  std::optional<Decision> decided_further(const PathPart<T>& part, const PairMotion<BasicInterval<T>>& widened,
                                          bool crosses) {
    if constexpr (std::is_same_v<T, double>) {
      const int most_parts = std::min(kMostWithinPart, fine_parts_left_);
      PathSolver<kind, DoubleDouble> fine(question_, reader_, {part.from.time, part.to.time}, most_parts);
      const Decision decision = fine.run();
      fine_parts_left_ -= fine.parts_looked_at();
      return decision.is_free() ? std::nullopt : std::optional(decision);
    } else {
      const bool touches = crosses && part.length() <= question_.tolerance && stays_inside<kind>(widened);
      return Decision{touches ? Verdict::touches : Verdict::unsure, part.from.time, part.to.time};
    }
  }

  const PathQuestion& question_;
  const PairReader& reader_;
  PathParts<T> parts_;
  int parts_left_, fine_parts_left_ = kMostFineParts;
};

/// The sign of the pair's coplanarity at a moment, by doubles, or where these cannot tell by double-double, which costs
/// ten times as much. 0: neither can tell.
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

/// By the chord between the ends of the bracket; the side on which it begins is read from the path itself.
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

/// Proven, at one time.
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
  return with_kind(question.kind,
                   [&](auto kind) { return PathSolver<kind(), double>(question, reader, time, kMostParts).run(); });
}

std::optional<Decision> decide_recontact_on_path(const PathQuestion& question, const TimeInterval<double>& time) {
  const double length = time.t_out - time.t_in;
  for (double part = 0x1p-20; part < 1; part = part < 0x1p-4 ? 2 * part : part + 0x1p-4)
    if (const double from = time.t_in + part * length; is_apart_on_path(question, from))
      return decide_on_path(question, {from, time.t_out});
  return std::nullopt;
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
