// The frame of the whole scene, which all ranks find together. The boxes of every search are floats in it
// (docs/numerics/one-pair.md, "Boxes").
#pragma once
#include "distributed/src/communicator.hpp"
#include "distributed/src/input_part.hpp"
#include "search/bounds/box_frame.hpp"

namespace tamis::distributed {

/// Collective. Each rank speaks for the vertices whose home it is. `input`: with motions.
BoxFrame frame_of_scene(Communicator& communicator, const InputPart& input, double min_separation);

}  // namespace tamis::distributed
