// Adapts to the differences between the commits that the matrix is built against.
#pragma once
#include <cstdint>

#include "matrix/cells.hpp"
#include "tamis/statistics.hpp"
#include "tamis/step.hpp"

namespace tamis::matrix {

/// The pairs of all kinds that this version counts.
template <class Stage>
std::uint64_t pairs_of(const Stage& stage) {
  if constexpr (requires { stage.ve; })
    return stage.vf + stage.ee + stage.ve + stage.vv;
  else
    return stage.vf + stage.ee;
}

/// Has every pair decided, also in versions that make this an option.
template <class AnyOptions>
void decide_all(AnyOptions& options) {
  if constexpr (requires { options.guarantee; }) options.guarantee = decltype(options.guarantee)::exact;
}

/// Calls safe_step by the name that this version has for it.
template <class AnyDetector, class AnyStep>
auto safe_step(AnyDetector& detector, const AnyStep& step, double keep) {
  if constexpr (requires { detector.safe_step(step, keep); })
    return detector.safe_step(step, keep);
  else
    return detector.keep_distance(step, keep);
}

/// Does this version answer questions about positions? If not, the matrix has no such cells.
template <class AnyDetector>
concept AsksPositions = requires(AnyDetector& detector, const Step& step) {
  (void)detector.truncate(step, 0.1);
  (void)detector.pairs_within(step.end, 0.1);
  (void)detector.intersections(step.end);
};

/// Calls timed(ask) if the question is about positions, or truncate.
template <class AnyDetector, class Timed>
void ask_positions(AnyDetector& detector, Question question, const Step& step, double keep, double distance,
                   const Timed& timed) {
  if constexpr (AsksPositions<AnyDetector>) {
    if (question == Question::truncate) timed([&] { return detector.truncate(step, keep); });
    if (question == Question::within)
      timed([&]() -> decltype(auto) { return detector.pairs_within(step.end, distance); });
    if (question == Question::intersections)
      timed([&]() -> decltype(auto) { return detector.intersections(step.end); });
  }
}

}  // namespace tamis::matrix
