#include "files/view/outputs.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "files/error.hpp"
#include "files/extension.hpp"
#include "files/output/contacts_csv.hpp"
#include "files/output/contacts_vtk.hpp"
#include "files/output/glb.hpp"
#include "files/output/near_csv.hpp"
#include "files/view/viewer_page.hpp"

namespace tamis::io {
namespace {

void write_csv(const std::filesystem::path& path, const Recording& recording) {
  if (recording.pose)
    write_intersections_csv(path, recording.pose->intersections);
  else
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
    Output{"csv", true, false, write_csv},        Output{"html", true, true, write_viewer_page},
    Output{"glb", false, false, write_first_glb}, Output{"vtp", false, false, write_vtp},
    Output{"vtu", false, false, write_vtu},
};

}  // namespace

std::span<const Output> outputs() { return kOutputs; }

const Output& output_for(const std::filesystem::path& path, std::span<const Output> choices, NoExtension without) {
  if (extension_of(path) == ".png")
    throw FileError(path.string(), "",
                    fmt::format("pictures are saved from the page: write {}, open it and press K",
                                std::filesystem::path(path).replace_extension("html").string()));
  std::vector<std::string_view> extensions;
  for (const Output& output : choices) extensions.emplace_back(output.extension);
  return choices[format_of(path, extensions, without)];
}

std::string extensions(std::span<const Output> choices) {
  std::string text;
  for (const Output& output : choices) text += (text.empty() ? "" : ", ") + std::string(output.extension);
  return text;
}

}  // namespace tamis::io
