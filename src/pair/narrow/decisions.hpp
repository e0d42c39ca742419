// The stages that decide() tries on one pair, in this order (with a separation 4 comes before 3), until one of them
// decides it. If none does, integers do (pair/exact/exact.hpp).
#pragma once
#include <optional>

#include "pair/motion/decision.hpp"
#include "pair/motion/make_motion.hpp"
#include "pair/motion/pair_kinds.hpp"
#include "pair/motion/pair_motion.hpp"
#include "pair/motion/time_clip.hpp"
#include "pair/narrow/sharp_bracket.hpp"
#include "tamis/pair.hpp"

namespace tamis {

// 0. Nothing matters but whether the pair is free until a time: closing_in.cpp.

/// True if the pair is proven farther apart than its separation during `time`. Succeeds up to shortly before a time
/// when whole scenes come to one line or point. There signs are lost, but axes orthogonal to the line are not. Costs a
/// thousand instructions where one axis suffices. REQUIRES: `time` in [0,1], in order.
bool stays_apart_closing_in(const PairInStep& pair, const TimeInterval<double>& time);

// 1. One crossing, or two in halves of the time: decided_by_crossings.cpp.

/// Nothing where one or two crossings do not decide the pair, or where its distance does (is_about_distance). A pair
/// that is free until `latest` may be said to be free.
std::optional<PairResult> decided_by_crossings(const PairInStep& pair, double latest);

/// True if the clip proves the pair free until `latest`.
inline bool is_proven_free(const TimeInterval<double>& clip, double latest) {
  return clip.t_in > clip.t_out || clip.t_in > latest;
}

// 2. Edges in a plane orthogonal to a coordinate axis: decided_in_plane.cpp.

/// Nothing for other pairs, and where crossings do not decide: for edges that touch at the start, or end to end.
std::optional<PairResult> decided_in_plane(const PairInStep& pair);

// 3. Beginnings of the step, of a pair that goes far: pair_beginnings.cpp.

/// Decides the pair for the step, proven. Nothing where the pair does not go far, or doubles cannot tell.
std::optional<Decision> decide_in_beginnings(const PairInStep& pair);

// 4. Subdivision of the step, or with a separation advancement: decide_in_doubles.cpp.

/// The part of a time that the slab clip leaves. All of it where sizes are not finite.
TimeInterval<double> clipped(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

/// Unsure where sizes are not finite. REQUIRES: a motion that is not restricted; `time` as clipped() leaves it.
/// REQUIRES (not checked: exact): the pair is apart outside it.
Decision decide_in_doubles(PairKind kind, const PairMotion<double>& m, const TimeInterval<double>& time);

inline bool is_sharp_answer(const Decision& d) { return d.is_free() || (d.touches() && is_sharp(d.lower, d.upper)); }

// 5. The same in double-double: fine_crossing.cpp, fine_separation.cpp.

/// If `coarse` says that the pair touches: when it first does, between neighbouring doubles. If `coarse` is unsure:
/// whether the pair touches where its four points are coplanar, and when (in structured meshes most vertices that come
/// to edges do so within rounding). Nothing where double-double proves neither, as where features touch exactly at a
/// border. REQUIRES: a kind that can cross, no separation, sizes that are finite; `coarse` is not free, its times lie
/// in [0,1]. REQUIRES (not checked: exact): the pair touches within these times, and not before; or, if `coarse` is
/// unsure, it does not touch outside of these times.
std::optional<Decision> decide_crossing_finely(const PairInStep& pair, const Decision& coarse);

/// A contact between neighbouring doubles. The pair is apart until the first, and within its separation at the second.
/// Nothing where double-double does not prove that. Costs some twelve thousand instructions. REQUIRES: sizes that are
/// finite; the pair is apart on [0, bracket.t_in); the bracket lies in [0,1].
std::optional<Decision> first_within_finely(const PairInStep& pair, const TimeInterval<double>& bracket);

// Instead of all these stages, for a pair within its separation at t=0 where such contacts are ignored: recontact.cpp.

/// Finds when the pair is first within its separation again after it has left it. Free if it never leaves, or never
/// comes back. Nothing where doubles cannot tell when, or whether, it leaves (docs/numerics/distances.md, "Ignored at
/// the start"). REQUIRES: the motion of the whole step, finite; a separation > 0.
std::optional<Decision> first_recontact_within(PairKind kind, const PairMotion<double>& m);

}  // namespace tamis
