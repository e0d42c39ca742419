#include "solve/extended.hpp"

namespace tamis {

Decision decide_in_extended(PairKind kind, const PairPoints& points, const TimeInterval<double>& time) {
  return subdivide(kind, make_extended_motion(kind, points), time);
}

TimeInterval<double> sharpened(PairKind kind, const PairPoints& points, const TimeInterval<double>& bracket) {
  const Decision d = decide_in_extended(kind, points, bracket);
  return d.verdict == Verdict::touches ? TimeInterval<double>{d.lower, d.upper} : bracket;
}

}  // namespace tamis
