// Random motions of one pair of features. Each family of motions aims at one way of losing a contact.
#pragma once
#include <array>
#include <cmath>
#include <string_view>

#include "oracle/oracle.hpp"
#include "pair/motion/make_motion.hpp"
#include "scenes/random.hpp"
#include "support/describe.hpp"

namespace tamis::test {

using scenes::Random;

struct Family {
  std::string_view name;
  oracle::Motion (*make)(PairKind, Random&);
};

/// random: corners anywhere in a box, motion of the same size.
/// separated: the same, with the second feature two boxes away: nearly always free.
/// exact_contact: an exact contact at a known dyadic time and place; often on the border of a feature or of the step.
/// near_contact: the same, with each coordinate moved by some units in its last places: contact or just no contact.
/// lattice: corners on a lattice of few points: often coplanar, collinear, parallel or coincident.
/// degenerate: on the lattice, with edges of no length, faces of no area, features at rest, features that coincide.
/// in_plane: all points move within one plane, which moves too.
/// mirrored: the second feature is the first one's image in x = 0 (vf, ve: its point on the mirror).
/// nudged: exact_contact with one coordinate moved to the next double.
/// uneven: exact_contact flattened and sheared, so that lengths differ by up to 2^88; half of them nudged.
extern const std::array<Family, 10> kFamilies;

/// REQUIRES: a family has this name.
const Family& family_named(std::string_view name);

/// A change of unit and place, which must keep every certificate true.
struct Placement {
  std::string_view name;
  double scale;
  double offset;
};
extern const std::array<Placement, 6> kPlacements;
oracle::Motion placed(oracle::Motion motion, const Placement& placement);

/// The same pair with its vertices in another order, chosen at random.
oracle::Motion permuted(PairKind kind, const oracle::Motion& motion, Random& random);

/// A separation between a millionth of the features' size and their size. Half of them are multiples of 1/8, so that
/// features on lattices graze them exactly.
inline double separation_of_any_size(Random& random) {
  return random.coin() ? std::ldexp(1.0 + random.unit(), -random.below(20)) : 0.125 * (1 + random.below(4));
}

inline PairPoints to_points(const oracle::Motion& motion) { return {motion.start, motion.end}; }

}  // namespace tamis::test
