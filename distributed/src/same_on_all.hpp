// Checks that all ranks give the same options and questions.
#pragma once
#include <string>
#include <vector>

#include "distributed/src/communicator.hpp"
#include "tamis/options.hpp"

namespace tamis::distributed {

/// Collective. Throws InvalidOptions on every rank if one says something else than rank 0; the message names the first
/// difference of the lowest such rank.
void require_same(Communicator& communicator, const std::vector<std::string>& sayings);

/// The options that change the answer, as text.
std::vector<std::string> sayings_of(const Options& options);
/// A number as text that reads back as the same number.
std::string exact(double number);

}  // namespace tamis::distributed
