// A program of verbs, from its command line to its exit code.
#pragma once
#include <memory>
#include <vector>

#include "command/command_line/verb.hpp"

namespace tamis::cli {

struct Command {
  const char* name;
  const char* description;
  std::vector<std::unique_ptr<Verb>> verbs;  ///< in the order of the help
};

/// Picks the verb and runs it; every error is one sentence on stderr and exit code 2.
int run_command(const Command& command, int argc, char** argv);

}  // namespace tamis::cli
