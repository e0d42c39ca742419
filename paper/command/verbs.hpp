// The verbs of `tamis-lab`.
#pragma once
#include <memory>

#include "command/command_line/verb.hpp"

namespace tamis::lab {

std::unique_ptr<cli::Verb> make_bench();
std::unique_ptr<cli::Verb> make_contacts();
std::unique_ptr<cli::Verb> make_paper();
std::unique_ptr<cli::Verb> make_queries();

}  // namespace tamis::lab
