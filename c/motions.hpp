// How bodies move, as C gives it.
#pragma once
#include <vector>

#include "tamis/tamis.h"
#include "tamis/world.hpp"

namespace tamis::c {

/// One for each of `given.count` bodies.
std::vector<BodyMotion> motions_of(const tamis_motions& given);

}  // namespace tamis::c
