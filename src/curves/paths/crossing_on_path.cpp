#include <algorithm>

#include "curves/paths/chords.hpp"
#include "curves/paths/first_on_path.hpp"
#include "curves/paths/path_parts.hpp"
#include "numbers/assert.hpp"
#include "pair/narrow/crossing.hpp"

namespace tamis {
namespace {

/// The coplanarity's sign at the start if it is certainly the opposite at the end, else 0.
template <class T>
int side_before_crossing(const PairMotion<BasicInterval<T>>& ends) {
  const int start = side_of(ends.e.at0, ends.f.at0, ends.d.at0), end = side_of(ends.e.at1, ends.f.at1, ends.d.at1);
  return start * end < 0 ? start : 0;
}

/// A time interval, as fractions of the part, around the root of the chords' coplanarity, as narrow as the deviations
/// allow. It is a guess: no proof relies on it. REQUIRES: `side_at_start` is -1 or 1. REQUIRES (not checked: history):
/// the pair is on the other side at the end.
template <class T>
TimeInterval<double> window_of(const PairMotion<BasicInterval<T>>& widened, int side_at_start) {
  TAMIS_ASSERT(side_at_start == 1 || side_at_start == -1);
  const auto k = coplanarity_polynomial(widened);
  std::array<double, 4> middle{};
  double width = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = i == 0 || i == 3 ? 1 : 3;  // k[1], k[2] are 3 times the Bernstein coefficients
    middle[i] = side_at_start * nearest_double(k[i].middle());
    width = max(width, farthest_from(k[i].middle(), k[i]) / weight);
  }
  const double root = crossing::find_root(middle), slope = abs(crossing::slope(middle, root));
  const double margin = 2 * width / slope + 0x1p-48;
  return {root - margin, root + margin};
}

/// Limits for one pair: parts that are looked at in doubles, and in double-double. Either takes half a second.
constexpr int kMostParts = 1 << 17, kMostFineParts = 1 << 13;
/// Cutting sharpens proofs while deviations exceed the errors of positions. Below that it helps only because chords
/// turn less on shorter parts. This matters for parts longer than this.
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
  /// The final decision if the part holds the earliest time not proven free. Nothing if it is free or was cut.
  std::optional<Decision> decided_by(const PathPart<T>& part) {
    const Chords<kind, T> chords(part.from, part.to, part.deviations, reader_.directions());
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
    if (--parts_left_ > 0 && may_gain(part, chords.gap_at_start(ends)) && !is_touch_in_bracket(part) &&
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

  /// Halves [from, to] until its first part is no longer than kShortest, or no double lies within. The end of that
  /// part.
  static double end_of_shortest(double from, double to) {
    while (to - from > kShortest<T>) {
      const double middle = near_middle(from, to);
      if (!(from < middle && middle < to)) break;
      to = middle;
    }
    return to;
  }

  /// True if cutting may make proofs sharper. In doubles it may not if the errors of positions are about as large as
  /// the gap. With a gap that is far larger than errors and deviations the pair comes together later in the part.
  bool may_gain(const PathPart<T>& part, double gap_at_start) const {
    const double error = std::max(part.from.error, part.to.error);
    if (std::is_same_v<T, double> && !(gap_at_start > 8 * error)) return false;
    const double deviation = *std::ranges::max_element(part.deviations);
    return deviation > 4 * error || part.length() > kShortest<T> || gap_at_start > 64 * (error + deviation);
  }

  /// True if the features are flat on each other at the end of the part, as far as double-double can tell, and the part
  /// is a bracket. Features that turn in their common plane lie like this. Shorter parts give no certificate either.
  bool is_touch_in_bracket(const PathPart<T>& part) const {
    if (std::is_same_v<T, double> || part.length() > question_.tolerance) return false;
    constexpr std::array<double, 4> kNoDeviations{};
    const auto end = Chords<kind, T>(part.to, part.to, kNoDeviations).at_ends();
    return side_of(end.e.at1, end.f.at1, end.d.at1) == 0 && stays_inside<kind>(end);
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

  /// Decides a part that this arithmetic gains nothing from cutting. Doubles call double-double, whose answer is final.
  std::optional<Decision> decided_further(const PathPart<T>& part, const PairMotion<BasicInterval<T>>& widened,
                                          bool crosses) {
    if constexpr (std::is_same_v<T, double>) {
      PathSolver<kind, DoubleDouble> fine(question_, reader_, {part.from.time, part.to.time}, fine_parts_left_);
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

}  // namespace

Decision first_crossing_on_path(const PathQuestion& question, const PairReader& reader,
                                const TimeInterval<double>& time) {
  TAMIS_ASSERT(is_part_of_step(time));
  return with_kind(question.kind,
                   [&](auto kind) { return PathSolver<kind(), double>(question, reader, time, kMostParts).run(); });
}

}  // namespace tamis
