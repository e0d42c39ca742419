// What all ranks must say alike: options, and questions.
#pragma once
#include <string>
#include <vector>

#include "mpi/src/communicator.hpp"
#include "tamis/options.hpp"

namespace tamis::distributed {

/// Collective. Throws InvalidOptions, on every rank, naming the first that says something else than rank 0.
void require_same(Communicator& communicator, const std::vector<std::string>& sayings);

/// Those of the options that change the answer.
std::vector<std::string> sayings_of(const Options& options);
/// A number that reads back as it is.
std::string exact(double number);

}  // namespace tamis::distributed
