#include "longrun/tally.hpp"

#include <cstdio>

#include "support/describe.hpp"

namespace tamis::test {

void Tally::require(bool promise, const char* what, PairKind kind, const oracle::Motion& motion) {
  if (promise) return;
  constexpr int kShown = 10;
  if (++failures <= kShown) std::fprintf(stderr, "%s: %s\n", what, describe(kind, motion).c_str());
}

void Tally::add(PairKind kind, const oracle::Motion& motion, const PairResult& answer, const Truth& truth,
                bool checks_times) {
  ++pairs;
  touching += truth.touches();
  require(answer.touches || !truth.touches(), "missed contact", kind, motion);
  require(!answer.touches || truth.touches(), "touches, but free", kind, motion);
  require(answer.certainty == Certainty::certified, "not certified", kind, motion);
  if (!checks_times || !answer.touches) return;
  const double lower = answer.toi_lower, upper = answer.toi_upper;
  require(0 <= lower && lower <= upper && upper <= 1, "no bracket within the step", kind, motion);
  require(!truth.touches_before(lower), "touches before toi_lower", kind, motion);
  require(truth.touches_within(lower, upper), "does not touch within the bracket", kind, motion);
}

std::string Tally::line() const {
  const auto named = [](const char* name, std::int64_t count) { return std::to_string(count) + ' ' + name; };
  return named("pairs, ", pairs) + named("touch, ", touching) + named("failures", failures);
}

}  // namespace tamis::test
