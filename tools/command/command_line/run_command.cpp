#include "command/command_line/run_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "command/command_line/command_line.hpp"
#include "command/command_line/messages.hpp"
#include "files/system.hpp"
#include "tamis/error.hpp"
#include "tamis/options.hpp"

namespace tamis::cli {
namespace {

int fail_to_print() { return fail("the result cannot be written to the standard output: check where it leads"); }

/// What was printed must have arrived: a full disk behind stdout is an error too.
int finish(int code) { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? code : fail_to_print(); }

/// The verb and the names that follow it: they tell which of many commands failed.
std::string subject_of(const CLI::App& verb) {
  std::string subject = verb.get_name();
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional())
      for (const std::string& word : option->results()) subject += " " + word;
  return subject;
}

int fail_for_memory(const CLI::App& verb) {
  return fail(subject_of(verb) + ": not enough memory: use a smaller mesh or a larger machine");
}

int run(Verb& verb, const CLI::App& app) {
  try {
    return finish(verb.run());
  } catch (const std::bad_alloc&) {
    return fail_for_memory(app);
  } catch (const std::length_error&) {
    return fail_for_memory(app);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return fail_to_print();
    const bool is_sentence = dynamic_cast<const Error*>(&error) || dynamic_cast<const CLI::Error*>(&error);
    return is_sentence ? fail(error.what())
                       : fail(fmt::format("{}: '{}': check the limits of memory, threads and files ('ulimit -a')",
                                          subject_of(app), error.what()));
  }
}

int parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return finish(app.exit(error));
  if (app.get_subcommands().empty() && dynamic_cast<const CLI::RequiredError*>(&error))
    return fail(fmt::format("no verb is given: see '{} --help'", app.get_name()));
  std::string verb;
  for (const CLI::App* used : app.get_subcommands()) verb = " " + used->get_name();
  return fail(fmt::format("{}: see '{}{} --help'", error.what(), app.get_name(), verb));
}

void declare(const Command& command, CLI::App& app) {
  app.set_version_flag("--version", fmt::format("{} {}\nthreads: {}", command.name, TAMIS_VERSION,
                                                has_threads() ? "oneTBB" : "one, built without oneTBB"));
  app.require_subcommand(1);
  app.footer(
      fmt::format("'{} VERB --help' explains a verb and gives examples.\n"
                  "Exit codes: 0 done, 1 the answer is no, 2 error.",
                  command.name));
  for (const auto& verb : command.verbs) {
    CLI::App* sub = app.add_subcommand(verb->name(), verb->summary());
    OptionList options(*sub);
    verb->declare(options);
    sub->footer(fmt::format("Examples:\n{}", verb->examples()));
  }
}

int run_words(const Command& command, const std::vector<std::string>& given) {
  system::prepare_streams();
  CLI::App app(command.description, command.name);
  app.allow_windows_style_options(false);  // /folder/file is a name on Windows, too
  declare(command, app);
  const std::string first = given.empty() ? "" : given.front();
  const bool has_verb = !given.empty() && !first.starts_with('-');
  const auto is_called = [&](const auto& verb) { return first == verb->name(); };
  if (has_verb && std::none_of(command.verbs.begin(), command.verbs.end(), is_called))
    return fail(fmt::format("unknown verb '{}': see '{} --help'", first, command.name));
  std::vector<std::string> words = words_for_parser(given);
  if (has_verb)
    require_sound(*app.get_subcommand(first), words);
  else if (given.size() > 1 && app.get_option_no_throw(first) == nullptr)
    return fail(fmt::format("{} comes before the verb: options follow it, as in '{} VERB FILES {}'", first,
                            command.name, first));
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    return parse_error(app, error);
  }
  for (const auto& verb : command.verbs)
    if (app.got_subcommand(verb->name())) return run(*verb, *app.get_subcommand(verb->name()));
  return kError;
}

}  // namespace

int run_command(const Command& command, int argc, char** argv) {
  try {
    return run_words(command, system::words_of(argc, argv));
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace tamis::cli
