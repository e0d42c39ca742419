// Distances at one time, decided exactly: by estimates where all signs are plain, else in integers.
#pragma once
#include <optional>

#include "motion/make_motion.hpp"

namespace tamis {

/// As NearPair has them, each rounded by a few u of itself; `direction` along the gap (distance/closest.hpp).
/// Where there is none the one that it had before, as the features came together; of those that did not the normal, or
/// zero where there is none.
struct ExactDistance {
  double distance, u, v;
  Vec3<double> direction;
};

/// REQUIRES, all: finite coordinates, `time` in [0,1].
ExactDistance exact_distance(PairKind kind, const PairPoints& points, double time = 0);

/// Its two halves. By estimates, at t=0 (later times make long integers, of which they rarely know what is left where
/// much cancels): none where a sign is not plain.
std::optional<ExactDistance> estimated_distance(PairKind kind, const PairPoints& points);
ExactDistance distance_in_integers(PairKind kind, const PairPoints& points, double time);

/// Along e x f (motion/pair_motion.hpp), of unit length; zero if that is.
Vec3<double> exact_normal(PairKind kind, const PairPoints& points, double time);

}  // namespace tamis
