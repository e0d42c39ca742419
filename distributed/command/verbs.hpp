// The verbs of tamis-mpi.
#pragma once
#include <memory>

#include "command/command_line/verb.hpp"

namespace tamis::distributed {

std::unique_ptr<cli::Verb> make_contacts();
std::unique_ptr<cli::Verb> make_earliest();
std::unique_ptr<cli::Verb> make_safe_step();
std::unique_ptr<cli::Verb> make_is_free();
std::unique_ptr<cli::Verb> make_sequence();

}  // namespace tamis::distributed
