#include "paths/decide_path.hpp"

#include <algorithm>

#include "paths/crossing_on_path.hpp"
#include "paths/path_parts.hpp"
#include "paths/within_on_path.hpp"
#include "solve/weights.hpp"

namespace tamis {
namespace {

/// What is spent on one pair in one arithmetic. While strays are larger than errors cutting makes proofs sharper; below
/// that only because chords turn less, for parts longer than kShortest.
template <class T>
struct Effort;
template <>
struct Effort<double> {
  static constexpr int kParts = 1 << 17;
  static constexpr double kShortest = 0x1p-6;
};
template <>
struct Effort<DoubleDouble> {
  static constexpr int kParts = 1 << 13;
  static constexpr double kShortest = 0x1p-100;
};

/// At no simple fraction: contacts happen at those, and one at a cut is undecided on both sides.
double near_middle(double from, double to) {
  constexpr double kNearMiddle = 0.48713;
  return from + kNearMiddle * (to - from);
}

template <PairKind kind, class T>
class PathSolver {
 public:
  PathSolver(const PairReader& reader, double tolerance, const TimeInterval<double>& time)
      : reader_(reader), tolerance_(tolerance), parts_(reader, time) {}

  Decision run() {
    Decision decision;
    while (auto part = parts_.next())
      if (settles(*part, decision)) break;
    return decision;
  }

 private:
  /// True if `decision` is final: the earliest time that cannot be proven free is known.
  bool settles(const PathPart<T>& part, Decision& decision) {
    const std::array<double, 4> strays = reader_.strays(part.from.time, part.to.time);
    const Chords<kind, T> chords(part.from, part.to, strays);
    const auto ends = chords.at_ends();
    if (chords.axis_proves_free(ends)) return false;
    const auto widened = chords.motion();
    if constexpr (can_cross(kind)) {
      if (Dnf::proves_free<kind>(widened) || Ncf::proves_free<kind>(widened)) return false;
    }
    const PathCrossing crossing = can_cross(kind) ? crossing_of(ends) : PathCrossing{};
    if (crossing.is_opposite()) {
      const bool is_narrow = part.length() <= tolerance_ && part.from.time > 0;
      if (is_narrow && stays_inside<kind>(widened)) {
        decision = {Verdict::touches, part.from.time, part.to.time};
        return true;
      }
      if (cut_around_crossing(part, window_of(widened, crossing.sign_at_start))) return false;
    }
    const double stray = *std::max_element(strays.begin(), strays.end());
    const bool may_gain = stray > 4 * std::max(part.from.error, part.to.error) || part.length() > Effort<T>::kShortest;
    if (++looked_at_ < Effort<T>::kParts && may_gain && parts_.cut(part, near_middle(part.from.time, part.to.time)))
      return false;
    return settles_further(part, widened, crossing, decision);
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

  /// Where this arithmetic ends.
  bool settles_further(const PathPart<T>& part, const PairMotion<BasicInterval<T>>& widened,
                       const PathCrossing& crossing, Decision& decision) {
    if constexpr (std::is_same_v<T, double>) {
      decision = PathSolver<kind, DoubleDouble>(reader_, tolerance_, {part.from.time, part.to.time}).run();
      return decision.verdict != Verdict::is_free;
    } else {
      const bool touches = crossing.is_opposite() && part.length() <= tolerance_ && stays_inside<kind>(widened);
      decision = {touches ? Verdict::touches : Verdict::unsure, part.from.time, part.to.time, touches};
      return true;
    }
  }

  const PairReader& reader_;
  const double tolerance_;
  PathParts<T> parts_;
  int looked_at_ = 0;
};

}  // namespace

Decision decide_on_path(const PathQuestion& question, const TimeInterval<double>& time) {
  PairReader reader(question.path, question.vertices);
  reader.set_unit_at(time.t_in);
  if (question.options.min_separation > 0) return first_within_on_path(question, reader, time);
  return with_kind(question.kind, [&](auto kind) {
    return PathSolver<kind(), double>(reader, question.options.tolerance, time).run();
  });
}

PairResult result_on_path(const PathQuestion& question, const Decision& decision) {
  PairResult result;
  if (decision.verdict == Verdict::is_free) return result;
  result.touches = true;
  result.certainty = decision.verdict == Verdict::touches ? Certainty::certified : Certainty::unresolved;
  result.toi_lower = decision.lower;
  result.toi_upper = decision.upper;
  PairReader reader(question.path, question.vertices);
  const PairPoints points = points_between(reader.at<double>(decision.lower), reader.at<double>(decision.upper));
  add_weights(question.kind, make_motion(question.kind, points), 0.5, result);
  return result;
}

}  // namespace tamis
