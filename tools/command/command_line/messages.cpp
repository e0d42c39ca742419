#include "command/command_line/messages.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "command/command_line/printable.hpp"
#include "command/command_line/verb.hpp"

namespace tamis::cli {
namespace {

void write_line(std::string_view head, std::string_view sentence) noexcept {
  try {
    std::string line(sentence);
    std::replace(line.begin(), line.end(), '\n', ' ');
    show(std::string(head) + printable(line) + "\n");
  } catch (const std::exception&) {
    show("tamis: not enough memory to say what is wrong\n");
  }
}

}  // namespace

void show(std::string_view text) noexcept {
  // Ignores a failure: there is nowhere else to report it, and the exit code tells.
  if (std::fwrite(text.data(), 1, text.size(), stderr) == text.size()) std::fflush(stderr);
}

void note(std::string_view sentence) noexcept { write_line("note: ", sentence); }

int fail(std::string_view sentence) noexcept {
  const std::size_t last = sentence.find_last_not_of(" .\n");
  write_line("tamis: ", sentence.substr(0, last == std::string_view::npos ? 0 : last + 1));
  return kError;
}

}  // namespace tamis::cli
