#include "io/view/outputs.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "io/contacts_csv.hpp"
#include "io/contacts_vtk.hpp"
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

std::string lower_extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  if (!text.empty()) text.erase(0, 1);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::span<const Output> outputs() { return kOutputs; }

const Output* find_output(std::span<const Output> choices, const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  const auto found =
      std::find_if(choices.begin(), choices.end(), [&](const Output& output) { return extension == output.extension; });
  return found == choices.end() ? nullptr : &*found;
}

std::string extensions(std::span<const Output> choices) {
  std::string text;
  for (const Output& output : choices) text += (text.empty() ? "" : ", ") + std::string(output.extension);
  return text;
}

}  // namespace tamis::io
