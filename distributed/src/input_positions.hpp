// Makes the motions of all vertices that a rank gives or uses, from the caller's rows.
#pragma once
#include "distributed/src/communicator.hpp"
#include "distributed/src/input_part.hpp"
#include "tamis/step.hpp"

namespace tamis::distributed {

/// Collective. Fills part.elements.motions: each vertex has the position that its home gives. Throws InvalidStep if
/// rows do not fit, if ranks give one vertex different positions, or if a vertex that is used is not finite.
void take_positions(Communicator& communicator, const Step& step, InputPart& part);

}  // namespace tamis::distributed
