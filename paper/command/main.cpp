// The command `tamis-lab`: its verbs.
#include <exception>

#include "command/command_line/messages.hpp"
#include "command/command_line/run_command.hpp"
#include "paper/command/verbs.hpp"

namespace tamis::lab {
namespace {

cli::Command make_command() {
  cli::Command command{"tamis-lab",
                       "The laboratory of Tamis: the paper's pipeline and its competitors, its evaluation, and queries "
                       "with known answers.",
                       {}};
  command.verbs.push_back(make_contacts());
  command.verbs.push_back(make_bench());
  command.verbs.push_back(make_paper());
  command.verbs.push_back(make_queries());
  return command;
}

}  // namespace
}  // namespace tamis::lab

int main(int argc, char** argv) {
  try {
    return tamis::cli::run_command(tamis::lab::make_command(), argc, argv);
  } catch (const std::exception& error) {
    return tamis::cli::fail(error.what());
  }
}
