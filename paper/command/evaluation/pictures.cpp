#include "paper/command/evaluation/pictures.hpp"

#include <fmt/format.h>

#include <array>

#include "paper/command/data_file.hpp"
#include "paper/command/program.hpp"

namespace tamis::lab {
namespace {

/// The user's Python first, then the system's: distributions package matplotlib for the system's, and a virtual
/// environment often lacks it.
constexpr std::array kInterpreters{"python3", "/usr/bin/python3"};

/// Empty if there is none; then `why` says what is missing.
std::string interpreter_with_matplotlib(std::string& why) {
  why = "there is no python3 (Debian: apt-get install python3 python3-matplotlib)";
  for (const char* interpreter : kInterpreters) {
    const int code = run_quietly({interpreter, "-c", "import matplotlib"});
    if (code == 0) return interpreter;
    if (code != kNotStarted) why = "python3 has no matplotlib (Debian: apt-get install python3-matplotlib)";
  }
  return {};
}

}  // namespace

std::string draw_pictures(const std::filesystem::path& folder) {
  const std::filesystem::path script = data_file("plot_paper.py");
  if (!std::filesystem::exists(script))
    return fmt::format("{} is not there: install it with the command", script.string());
  std::string why;
  const std::string interpreter = interpreter_with_matplotlib(why);
  if (interpreter.empty()) return why;
  const int code = run_quietly({interpreter, script.string(), folder.string()});
  // Python's own message is not repeated: it fills pages.
  return code == 0 ? ""
                   : fmt::format("{} {} ended with exit code {}: run it on '{}' to see why", interpreter,
                                 script.string(), code, folder.string());
}

}  // namespace tamis::lab
