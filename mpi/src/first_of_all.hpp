// The first of several answers: of the searches of one rank, and of all ranks.
#pragma once
#include "mpi/src/communicator.hpp"
#include "tamis/contact.hpp"
#include "tamis/step_length.hpp"

namespace tamis::distributed {

/// Of two searches of one rank.
void keep_first(EarliestContact& first, const EarliestContact& other);
void keep_first(SafeStep& first, const SafeStep& other);

/// Collective. By the least time, then kind and vertices; of `upper` the least, that of a safe step being of its pair.
EarliestContact first_of_all(Communicator& communicator, const EarliestContact& mine);
SafeStep first_of_all(Communicator& communicator, const SafeStep& mine);

}  // namespace tamis::distributed
