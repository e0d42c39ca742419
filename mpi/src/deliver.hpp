// Contacts of several searches as one list, and each on its rank.
#pragma once
#include <vector>

#include "mpi/src/communicator.hpp"
#include "mpi/src/local_search.hpp"

namespace tamis::distributed {

/// By kind, then vertices: the order of contacts.
bool comes_before(const Contact& a, const Contact& b);

/// Collective. Every contact that any rank has found, in any of its lists, once, on its home and in order. Where
/// features are given several times, as are their contacts: as often as the list has it that has it most.
std::vector<Contact> deliver(Communicator& communicator, const std::vector<std::vector<HomedContact>>& found);

/// Collective. All contacts in order on `root`, none elsewhere.
std::vector<Contact> gather(Communicator& communicator, const std::vector<Contact>& mine, int root);

}  // namespace tamis::distributed
