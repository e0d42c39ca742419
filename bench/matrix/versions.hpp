// What differs between the commits that the matrix is built against.
#pragma once
#include <array>
#include <cstdint>

#include "tamis/mesh.hpp"
#include "tamis/statistics.hpp"

namespace tamis::matrix {

/// Of all kinds that this version counts.
template <class Stage>
std::uint64_t pairs_of(const Stage& stage) {
  if constexpr (requires { stage.ve; })
    return stage.vf + stage.ee + stage.ve + stage.vv;
  else
    return stage.vf + stage.ee;
}

/// Every pair is decided, in versions that leave the choice, too.
template <class AnyOptions>
void decide_all(AnyOptions& options) {
  if constexpr (requires { options.guarantee; }) options.guarantee = decltype(options.guarantee)::exact;
}

/// By the name that this version has for it.
template <class AnyDetector, class AnyStep>
auto safe_step(AnyDetector& detector, const AnyStep& step, double keep) {
  if constexpr (requires { detector.safe_step(step, keep); })
    return detector.safe_step(step, keep);
  else
    return detector.keep_distance(step, keep);
}

/// Does this version answer questions about positions? Else the matrix has no cells of them, and none of these is
/// called.
template <class AnyDetector, class AnyPositions>
concept AsksPositions = requires(AnyDetector& detector, const AnyPositions& positions) {
  detector.pairs_within(positions, 0.1);
  detector.truncate({positions, positions}, 0.1);
  detector.intersections(positions);
};

/// What a question is answered with that this version does not know: nothing.
struct Unknown {
  std::array<Point, 0> positions;
};

template <class AnyDetector, class AnyStep>
decltype(auto) truncate(AnyDetector& detector, const AnyStep& step, double keep) {
  if constexpr (requires { detector.truncate(step, keep); })
    return detector.truncate(step, keep);
  else
    return Unknown{};
}

template <class AnyDetector, class AnyPositions>
decltype(auto) within(AnyDetector& detector, const AnyPositions& positions, double distance) {
  if constexpr (requires { detector.pairs_within(positions, distance); })
    return detector.pairs_within(positions, distance);
  else
    return Unknown{};
}

template <class AnyDetector, class AnyPositions>
decltype(auto) intersections(AnyDetector& detector, const AnyPositions& positions) {
  if constexpr (requires { detector.intersections(positions); })
    return detector.intersections(positions);
  else
    return Unknown{};
}

}  // namespace tamis::matrix
