// Brings contacts of several searches together in one list, on their ranks.
#pragma once
#include <vector>

#include "distributed/src/communicator.hpp"
#include "distributed/src/local_search.hpp"

namespace tamis::distributed {

/// The order of contacts: by kind, then vertices.
bool comes_before(const Contact& a, const Contact& b);

/// Collective. Returns on each rank the contacts whose home it is, of all lists of all ranks, in order, each once.
/// Features that the mesh has several times have their contacts several times: as often as in the list that has them
/// most often.
std::vector<Contact> deliver(Communicator& communicator, const std::vector<std::vector<HomedContact>>& found);

/// Collective. Returns all contacts, in order, on `root`; none elsewhere.
std::vector<Contact> gather(Communicator& communicator, const std::vector<Contact>& mine, int root);

}  // namespace tamis::distributed
