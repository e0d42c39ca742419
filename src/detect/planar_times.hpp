// How far may each vertex of a pair go by itself? From the positions at one time, the vertices of each feature stay on
// their side of a plane between the two. A plan in doubles: detect/truncation.hpp proves what comes of it.
#pragma once
#include <algorithm>
#include <array>

#include "detect/stored.hpp"
#include "motion/make_motion.hpp"
#include "numerics/assert.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// The fractions of its distance that a pair keeps when a step is truncated: `keep`, and a little more, `together`,
/// while all vertices go together. Vertices that go on alone use the difference.
struct KeptFractions {
  /// REQUIRES: 0 < kept < 1.
  explicit KeptFractions(double kept) : keep(kept), together(std::min(1.25 * kept, kept + 0.25 * (1 - kept))) {
    TAMIS_ASSERT(0 < kept && kept < 1);
  }

  /// The fraction of its distance at t=0 that a pair has left at `time`, up to which all vertices go together.
  double at(double time) const { return time > 0 ? together : 1; }
  /// The fraction that planes placed at `time` leave: a little more than `keep`, for rounding.
  double between_planes(double time) const { return keep + (at(time) - keep) / 16; }

  double keep, together;
};

/// A pair that rests where it is at `time` of its step.
PairPoints at_rest_at(const PairPoints& points, double time);

/// What planes must leave between a pair.
struct PlanarRule {
  const KeptFractions& fractions;
  double separation;
  Stored stored;  ///< positions are rounded to these; what stays where it starts is not
};

/// For each vertex of the pair the last time, from `time` to 1, at which it is on its side. `there`: the pair at
/// `time`, up to which all vertices go together. A pair that starts within the separation keeps all of its distance.
/// REQUIRES: finite coordinates, 0 <= time <= 1.
std::array<double, 4> planar_times(const NearPair& there, const PairPoints& points, const PlanarRule& rule,
                                   double time);

}  // namespace tamis
