// Scenes of few bodies with many triangles each.
#pragma once
#include "integrations/bullet/throws/bodies.hpp"

namespace tamis::bullet {

/// Two gears of 1,120 and 1,920 triangles on axles, free of gravity: the smaller one turns at 20 rad/s and drives the
/// other. Their teeth have some play.
BodyScene gears();
/// Four rough balls, of about so many triangles each, are thrown onto each other in a pit of 1 x 1 m. REQUIRES:
/// triangles >= 48.
BodyScene rough_balls(int triangles);

}  // namespace tamis::bullet
