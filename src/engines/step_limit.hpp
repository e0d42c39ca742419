// The pair that ends the step first, found in any order.
#pragma once
#include <tuple>

#include "engines/pair_rules.hpp"
#include "motion/separations.hpp"
#include "solve/kept_distance.hpp"
#include "tamis/contact.hpp"

namespace tamis {

struct StepLimit {
  double time = 1;  ///< 1: no pair ends the step
  PairKind kind = PairKind::vertex_face;
  PairVertices vertices{};

  /// Of equal times the first in the order of contacts stays.
  void add(const StepLimit& other) {
    if (other.time < 1 && other.key() < key()) *this = other;
  }

  /// With the time at which the pair is proven to end the step, and its distance.
  SafeStep answer(const Step& step, double fraction, const Separations& separations) const {
    if (time == 1) return {};
    const DistanceRule rule{fraction, separations.between(kind, vertices)};
    const PairPoints points = points_of(step, vertices);
    return {time, fraction_is_left_at(kind, points, rule, time),
            LimitingPair{kind, vertices, start_distance(kind, points)}};
  }

 private:
  std::tuple<double, PairKind, PairVertices> key() const { return {time, kind, vertices}; }
};

}  // namespace tamis
