#include "io/view/outputs.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/contacts_csv.hpp"
#include "io/contacts_vtk.hpp"
#include "io/extension.hpp"
#include "io/glb.hpp"
#include "io/view/viewer_page.hpp"

namespace tamis::io {
namespace {

void write_csv(const std::filesystem::path& path, const Recording& recording) {
  write_contacts_csv(path, recording.steps.front().contacts);
}

void write_first_glb(const std::filesystem::path& path, const Recording& recording) {
  const FirstStep step(recording);
  write_glb(path, recording.mesh, step.start, step.end, recording.steps.front().contacts);
}

void write_vtp(const std::filesystem::path& path, const Recording& recording) {
  const FirstStep step(recording);
  write_contacts_vtp(path, recording.steps.front().contacts, step.start, step.end);
}

void write_vtu(const std::filesystem::path& path, const Recording& recording) {
  const FirstStep step(recording);
  write_contacts_vtu(path, recording.steps.front().contacts, step.start, step.end);
}

constexpr std::array kOutputs{
    Output{"csv", false, write_csv}, Output{"html", true, write_viewer_page}, Output{"glb", false, write_first_glb},
    Output{"vtp", false, write_vtp}, Output{"vtu", false, write_vtu},
};

}  // namespace

std::span<const Output> outputs() { return kOutputs; }

const Output* find_output(std::span<const Output> choices, const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  const std::string_view without_dot = std::string_view(extension).substr(extension.empty() ? 0 : 1);
  const auto found = std::find_if(choices.begin(), choices.end(),
                                  [&](const Output& output) { return without_dot == output.extension; });
  return found == choices.end() ? nullptr : &*found;
}

std::string extensions(std::span<const Output> choices) {
  std::string text;
  for (const Output& output : choices) text += (text.empty() ? "" : ", ") + std::string(output.extension);
  return text;
}

}  // namespace tamis::io
