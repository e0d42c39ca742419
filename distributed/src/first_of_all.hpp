// The first of several answers: of the searches of one rank, and of all ranks.
#pragma once
#include "distributed/src/communicator.hpp"
#include "tamis/contact.hpp"
#include "tamis/step_length.hpp"

namespace tamis::distributed {

/// Keeps in `first` the first answer of two searches of one rank.
void keep_first(EarliestContact& first, const EarliestContact& other);
void keep_first(SafeStep& first, const SafeStep& other);

/// Collective: the first answer of all ranks, by time, then kind and vertices. toi_upper is the least of all ranks; the
/// `toi_upper` of a safe step is that of its pair.
EarliestContact first_of_all(Communicator& communicator, const EarliestContact& mine);
SafeStep first_of_all(Communicator& communicator, const SafeStep& mine);

}  // namespace tamis::distributed
