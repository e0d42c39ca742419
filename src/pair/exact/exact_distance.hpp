// Distances at one time, decided exactly: by estimates where all signs are plain, else in integers.
#pragma once
#include <optional>

#include "pair/motion/make_motion.hpp"

namespace tamis {

/// As in NearPair, each off by a few u of itself. `direction` is along the gap (pair/distance/closest.hpp). If features
/// touch, it is the direction of their approach. If they did not move, their normal, or zero without one.
struct ExactDistance {
  double distance, u, v;
  Vec3<double> direction;
};

/// REQUIRES, all: finite coordinates, `time` in [0,1].
ExactDistance exact_distance(PairKind kind, const PairPoints& points, double time = 0);

/// The two halves of exact_distance(). Estimates serve t=0 alone, and give nothing where a sign is not certain.
/// Later times make long integers. Where most of their digits cancel, estimates rarely know the rest.
std::optional<ExactDistance> estimated_distance(PairKind kind, const PairPoints& points);
ExactDistance distance_in_integers(PairKind kind, const PairPoints& points, double time);

/// The unit vector along e x f (pair/motion/pair_motion.hpp) at `time`. Zero if e x f is.
Vec3<double> exact_normal(PairKind kind, const PairPoints& points, double time);

}  // namespace tamis
