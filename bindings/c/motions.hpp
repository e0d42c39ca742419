// Converts motions of bodies from C.
#pragma once
#include <vector>

#include "tamis/tamis.h"
#include "tamis/world.hpp"

namespace tamis::c {

/// One motion for each of `given.count` bodies.
std::vector<BodyMotion> motions_of(const tamis_motions& given);

}  // namespace tamis::c
