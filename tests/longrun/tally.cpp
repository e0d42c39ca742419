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
                bool is_exact, bool checks_times) {
  const bool is_certified = answer.touches && answer.certainty == Certainty::certified;
  ++pairs;
  touching += truth.touches();
  certified += is_certified;
  unresolved += answer.touches && !is_certified;
  unresolved_free += answer.touches && !is_certified && !truth.touches();
  require(answer.touches || !truth.touches(), "missed contact", kind, motion);
  require(!is_certified || truth.touches(), "certified, but free", kind, motion);
  require(!is_exact || is_certified == answer.touches, "exact, but unresolved", kind, motion);
  if (!checks_times || !answer.touches) return;
  const double lower = answer.toi_lower, upper = answer.toi_upper;
  require(0 <= lower && lower <= upper && upper <= 1, "no bracket within the step", kind, motion);
  require(!truth.touches_before(lower), "touches before toi_lower", kind, motion);
  require(!is_certified || truth.touches_within(lower, upper), "does not touch within the bracket", kind, motion);
}

std::string Tally::line() const {
  const auto named = [](const char* name, std::int64_t count) { return std::to_string(count) + ' ' + name; };
  return named("pairs, ", pairs) + named("touch, ", touching) + named("certified, ", certified) +
         named("unresolved (", unresolved) + named("of them free), ", unresolved_free) + named("failures", failures);
}

}  // namespace tamis::test
