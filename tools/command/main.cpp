// The command `tamis`: its verbs.
#include <exception>
#include <memory>

#include "command/command_line/messages.hpp"
#include "command/command_line/run_command.hpp"

namespace tamis::cli {

// The list of verbs is made by CMake, from the files verb_*.cpp that CMakeLists.txt names.
#define TAMIS_VERB(name) std::unique_ptr<Verb> make_##name();
#include "command/verbs.inc"
#undef TAMIS_VERB

namespace {

Command make_command() {
  Command command{
      "tamis",
      "Tamis finds every contact between moving, deforming triangle meshes: continuous collision detection.",
      {}};
#define TAMIS_VERB(name) command.verbs.push_back(make_##name());
#include "command/verbs.inc"
#undef TAMIS_VERB
  return command;
}

}  // namespace
}  // namespace tamis::cli

int main(int argc, char** argv) {
  try {
    return tamis::cli::run_command(tamis::cli::make_command(), argc, argv);
  } catch (const std::exception& error) {
    return tamis::cli::fail(error.what());
  }
}
