// How far each vertex of a pair may go by itself. Planes between the two features, placed at one time, stop each vertex
// before it leaves its feature's side. Computed in doubles without proof: api/truncation.hpp proves the resulting step.
#pragma once
#include <algorithm>
#include <array>

#include "api/stored.hpp"
#include "numbers/assert.hpp"
#include "pair/motion/make_motion.hpp"
#include "tamis/proximity.hpp"

namespace tamis {

/// The fractions of its distance that a pair keeps when a step is truncated: `keep` in the end, and `together`, a
/// little more, while all vertices go together. Vertices that continue alone use the difference.
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

/// The distance that planes must leave between a pair's features.
struct PlanarRule {
  const KeptFractions& fractions;
  double separation;
  StoredType stored;  ///< positions are rounded to these, except coordinates that do not change
};

/// For each vertex of the pair the last time in [`time`, 1] at which it is on its feature's side. `there`: the pair at
/// `time`, up to which all vertices go together. A pair that starts within the separation keeps all of its distance.
/// REQUIRES: finite coordinates, 0 <= time <= 1.
std::array<double, 4> planar_times(const NearPair& there, const PairPoints& points, const PlanarRule& rule,
                                   double time);

}  // namespace tamis
