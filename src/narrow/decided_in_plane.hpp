// Edges that move in one plane across a coordinate axis, as all of a 2D simulation do. They are coplanar at all times,
// so that no crossing tells when they touch; but they touch first where an end of one comes to the other, and there
// this other crosses the line through that end which stands upright on the plane.
#pragma once
#include <optional>

#include "motion/make_motion.hpp"
#include "tamis/pair.hpp"

namespace tamis {

/// Nothing of other pairs, and where these crossings do not decide it: of edges that touch at the start, or end to end.
std::optional<PairResult> decided_in_plane(const PairInStep& pair);

}  // namespace tamis
