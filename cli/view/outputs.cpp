#include "cli/view/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "cli/printable.hpp"
#include "cli/step_files.hpp"
#include "cli/view/viewer_page.hpp"
#include "io/contacts_csv.hpp"
#include "io/contacts_vtk.hpp"
#include "io/glb.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

void write_csv(const std::filesystem::path& path, const Recording& recording) {
  io::write_contacts_csv(path, recording.steps.front().contacts);
}

/// The one step of the recording, as it was decided.
struct OneStep {
  explicit OneStep(const Recording& recording) : start(recording.frames[0]), end(recording.frames[1]) {
    scale_step(start, end, recording.scale);
  }
  const std::vector<Point>& start;
  std::vector<Point> end;
};

void write_glb(const std::filesystem::path& path, const Recording& recording) {
  const OneStep step(recording);
  io::write_glb(path, recording.mesh, step.start, step.end, recording.steps.front().contacts);
}

void write_vtp(const std::filesystem::path& path, const Recording& recording) {
  const OneStep step(recording);
  io::write_contacts_vtp(path, recording.steps.front().contacts, step.start, step.end);
}

void write_vtu(const std::filesystem::path& path, const Recording& recording) {
  const OneStep step(recording);
  io::write_contacts_vtu(path, recording.steps.front().contacts, step.start, step.end);
}

constexpr std::array kOutputs{
    Output{"csv", false, write_csv}, Output{"html", true, write_viewer_page}, Output{"glb", false, write_glb},
    Output{"vtp", false, write_vtp}, Output{"vtu", false, write_vtu},
};

std::string lower_extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  if (!text.empty()) text.erase(0, 1);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

const Output* find_output(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  const auto found = std::find_if(kOutputs.begin(), kOutputs.end(),
                                  [&](const Output& output) { return extension == output.extension; });
  return found == kOutputs.end() ? nullptr : &*found;
}

const Output& output_for(const std::filesystem::path& path, std::size_t steps) {
  const Output* found = find_output(path);
  if (!found)
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
