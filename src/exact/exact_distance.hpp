// Distances at one time, decided exactly: by estimates where all signs are plain, else in integers.
#pragma once
#include <optional>

#include "motion/make_motion.hpp"

namespace tamis {

/// As in NearPair, each rounded by a few u of itself; `direction` along the gap (distance/closest.hpp). Of features
/// that touch it is the direction in which they came together; if they did not move, their normal, or zero without one.
struct ExactDistance {
  double distance, u, v;
  Vec3<double> direction;
};

/// REQUIRES, all: finite coordinates, `time` in [0,1].
ExactDistance exact_distance(PairKind kind, const PairPoints& points, double time = 0);

/// Its two halves. By words or estimates, at t=0 alone, none where a sign is not plain: later times make long integers,
/// and where much of these cancels estimates rarely know what is left.
std::optional<ExactDistance> estimated_distance(PairKind kind, const PairPoints& points);
ExactDistance distance_in_integers(PairKind kind, const PairPoints& points, double time);

/// Along e x f (motion/pair_motion.hpp), of unit length; zero if that is.
Vec3<double> exact_normal(PairKind kind, const PairPoints& points, double time);

}  // namespace tamis
