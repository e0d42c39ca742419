// Where two features touch: contact weights and the normal. Along the normal the first feature must go, or the second
// be pushed back, to part them. A pair that comes near (with a minimum separation, or of a kind that cannot cross) has
// the direction between the closest points at toi_lower. A pair that crosses has the normal of the face, or of both
// edges, towards the side where the first feature was. Doubles compute it where they can, integers the rest
// (docs/numerics/distances.md, "Normals").
#pragma once
#include "pair/motion/make_motion.hpp"
#include "pair/motion/time_clip.hpp"
#include "tamis/pair.hpp"

namespace tamis {

/// As in Contact.
struct ContactPlace {
  double u, v;
  Point normal;
};

inline void set_place(PairResult& result, const ContactPlace& place) {
  result.u = place.u;
  result.v = place.v;
  result.normal = place.normal;
}

/// The place of the closest points at `time`. REQUIRES, all: finite coordinates, times in [0,1] and in order.
ContactPlace closest_place(const PairInStep& pair, double time);
/// The same in integers, where doubles do not tell it.
ContactPlace exact_closest_place(PairKind kind, const PairPoints& points, double time);

/// The place of a crossing within `time`. `side`: the side of the second feature where the first one is before the
/// crossing, 1 or -1 along e x f, or 0 if there is none. REQUIRES: a kind that can cross.
ContactPlace crossing_place(const PairInStep& pair, const TimeInterval<double>& time, int side);

/// The place of a contact whose times are known.
ContactPlace contact_place(const PairInStep& pair, const TimeInterval<double>& time);

}  // namespace tamis
