#include "cli/view/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "cli/printable.hpp"
#include "cli/view/viewer_page.hpp"
#include "io/contacts_csv.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

void write_csv(const std::filesystem::path& path, const Recording& recording) {
  io::write_contacts_csv(path, recording.steps.front().contacts);
}

constexpr std::array kOutputs{
    Output{"csv", false, write_csv},
    Output{"html", true, write_viewer_page},
};

std::string lower_extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  if (!text.empty()) text.erase(0, 1);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

const Output& output_for(const std::filesystem::path& path, std::size_t steps) {
  const std::string extension = lower_extension(path);
  const auto found = std::find_if(kOutputs.begin(), kOutputs.end(),
                                  [&](const Output& output) { return extension == output.extension; });
  if (found == kOutputs.end())
    throw InvalidOptions(fmt::format("--out {}: no output has this extension: give one of {}", printable(path.string()),
                                     output_extensions()));
  if (steps > 1 && !found->holds_sequence)
    throw InvalidOptions(fmt::format("--out {}: such a file holds one step, not {}: name two frames, or write html",
                                     printable(path.string()), steps));
  return *found;
}

std::string output_extensions() {
  std::string text;
  for (const Output& output : kOutputs) text += fmt::format("{}{}", text.empty() ? "" : ", ", output.extension);
  return text;
}

}  // namespace tamis::cli
