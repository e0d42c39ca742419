#include "command/look_output.hpp"

#include <fmt/format.h>

#include <span>

#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "files/view/outputs.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {

std::vector<io::Output> LookOutput::choices() const {
  std::vector<io::Output> all(io::outputs().begin(), io::outputs().end());
  if (shown_ == Shown::pose) std::erase_if(all, [](const io::Output& output) { return !output.holds_pose; });
  return all;
}

void LookOutput::declare(OptionList& options) {
  std::string help = fmt::format("the file to write: {}", io::extensions(choices()));
  if (without_ == io::NoExtension::is_first_format) help += "; csv if the name has no extension";
  if (!path_.empty()) help += fmt::format("; default {}", path_.string());
  declare_output(options, path_, help);
}

io::Output LookOutput::output() const { return io::output_for(path_, choices(), without_); }

void LookOutput::check() const {
  if (!path_.empty()) static_cast<void>(output());
}

void LookOutput::require(const std::vector<std::filesystem::path>& inputs, std::size_t steps,
                         bool answer_is_alone) const {
  require_output(path_, inputs, answer_is_alone);
  check();
  if (path_.empty()) return;
  if (steps == 0 && !output().holds_pose)
    throw InvalidOptions(
        fmt::format("--out {}: such a file holds a step, not a single frame: name two frames, or write "
                    "html or csv",
                    printable(path_.string())));
  if (steps > 1 && !output().holds_sequence)
    throw InvalidOptions(fmt::format("--out {}: such a file holds one step, not {}: name two frames, or write html",
                                     printable(path_.string()), steps));
}

void LookOutput::write(const io::Recording& recording) const {
  if (path_.empty()) return;
  output().write(path_, recording);
}

io::Recording recording_of(const Detector& detector, const std::filesystem::path& name, std::vector<Point> positions,
                           std::span<const Intersection> found) {
  return {detector.mesh(),
          detector.options(),
          1,
          {utf8_text(name.filename().string())},
          {std::move(positions)},
          {},
          io::RecordedPose{{found.begin(), found.end()}, detector.statistics().stages, {}}};
}

}  // namespace tamis::cli
