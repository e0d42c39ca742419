// From the caller's rows to the motion of every vertex that a rank gives or uses.
#pragma once
#include "mpi/src/communicator.hpp"
#include "mpi/src/input_part.hpp"
#include "tamis/step.hpp"

namespace tamis::distributed {

/// Collective. Fills part.elements.motions: each vertex has the position that its home gives. Throws InvalidStep where
/// rows do not fit, where ranks give one vertex different positions, where one that is used is not finite.
void take_positions(Communicator& communicator, const Step& step, InputPart& part);

}  // namespace tamis::distributed
