// The command `tamis`: picks the verb, turns every error into one sentence and exit code 2.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cli/verb.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {

// The list of verbs is made by CMake, from the files verb_*.cpp that CMakeLists.txt names.
#define TAMIS_VERB(name) std::unique_ptr<Verb> make_##name();
#include "cli/verbs.inc"
#undef TAMIS_VERB

namespace {

std::vector<std::unique_ptr<Verb>> make_verbs() {
  std::vector<std::unique_ptr<Verb>> verbs;
#define TAMIS_VERB(name) verbs.push_back(make_##name());
#include "cli/verbs.inc"
#undef TAMIS_VERB
  return verbs;
}

int fail(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  message.erase(message.find_last_not_of(" .") + 1);
  fmt::print(stderr, "tamis: {}\n", message);
  return kError;
}

/// What was printed must have arrived: a full disk behind stdout is an error too.
int finish(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return fail("the result cannot be written to the standard output: check where it leads");
}

int parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return finish(app.exit(error));
  if (app.get_subcommands().empty() && dynamic_cast<const CLI::RequiredError*>(&error))
    return fail("no verb is given: see 'tamis --help'");
  std::string verb;
  for (const CLI::App* used : app.get_subcommands()) verb = " " + used->get_name();
  return fail(fmt::format("{}: see 'tamis{} --help'", error.what(), verb));
}

int run(int argc, char** argv) {
  CLI::App app("Tamis finds every contact between moving, deforming triangle meshes: continuous collision detection.",
               "tamis");
  app.set_version_flag("--version", "tamis " TAMIS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "'tamis VERB --help' explains a verb and gives examples.\nExit codes: 0 done, 1 the answer is no, 2 error.");
  const auto verbs = make_verbs();
  for (const auto& verb : verbs) {
    CLI::App* sub = app.add_subcommand(verb->name(), verb->summary());
    verb->declare(*sub);
    sub->footer(fmt::format("Examples:\n{}", verb->examples()));
  }
  const auto is_called = [&](const auto& verb) { return std::string_view(argv[1]) == verb->name(); };
  if (argc > 1 && argv[1][0] != '-' && std::none_of(verbs.begin(), verbs.end(), is_called))
    return fail(fmt::format("no verb is called '{}': see 'tamis --help'", argv[1]));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_error(app, error);
  }
  for (const auto& verb : verbs)
    if (app.got_subcommand(verb->name())) return finish(verb->run());
  return kError;
}

}  // namespace
}  // namespace tamis::cli

int main(int argc, char** argv) {
  try {
    return tamis::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return tamis::cli::fail("not enough memory: use a smaller mesh or a larger machine");
  } catch (const std::exception& error) {
    return tamis::cli::fail(error.what());
  }
}
