#include "command/look_output.hpp"

#include <fmt/format.h>

#include <span>

#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "files/view/outputs.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

bool is_picture(const io::Output& output) { return output.write == nullptr; }

}  // namespace

std::vector<io::Output> LookOutput::choices() const {
  std::vector<io::Output> all(io::outputs().begin(), io::outputs().end());
  all.push_back(io::kPicture);
  if (shown_ == Shown::pose) std::erase_if(all, [](const io::Output& output) { return !output.holds_pose; });
  return all;
}

void LookOutput::declare(OptionList& options) {
  std::string help = fmt::format("the file to write: {}", io::extensions(choices()));
  if (without_ == io::NoExtension::is_first_format) help += "; csv if the name has no extension";
  if (!path_.empty()) help += fmt::format("; default {}", path_);
  declare_output(options, path_, help);
  if (shown_ == Shown::steps)
    time_option_ = options.add_number("--time", "T", time_, NumberRange<double>{0, 1},
                                      "of a picture: show this time of the step; default 0, the start");
  options.add_numbers("--from", "X", from_, NumberRange<double>{},
                      "of a picture: look from this direction, three numbers as in -1,0.5,2; y is up");
  options.add_numbers("--size", "N", size_, NumberRange<int>{16, 8192},
                      "of a picture: width and height in pixels; default 1280,720");
}

io::Output LookOutput::output() const { return io::output_for(path_, choices(), without_); }

io::PictureOptions LookOutput::picture() const {
  io::PictureOptions options;
  options.time = time_;
  if (!from_.empty()) {
    if (from_.size() != 3 || (from_[0] == 0 && from_[1] == 0 && from_[2] == 0))
      throw InvalidOptions("--from is no direction: give three numbers that are not all zero, as in -1,0.5,2");
    options.from = {from_[0], from_[1], from_[2]};
  }
  if (!size_.empty()) {
    if (size_.size() != 2) throw InvalidOptions("--size takes a width and a height: give two numbers, as in 640,480");
    options.width = size_[0];
    options.height = size_[1];
  }
  return options;
}

void LookOutput::check() const {
  const bool draws = !path_.empty() && is_picture(output());
  if (draws) {
    io::require_pictures();
    picture();
  } else if (time_option_.is_given() || !from_.empty() || !size_.empty()) {
    throw InvalidOptions(fmt::format("{}--from and --size are of pictures: give --out a name that ends in .png as well",
                                     shown_ == Shown::steps ? "--time, " : ""));
  }
}

void LookOutput::require(const std::vector<std::filesystem::path>& inputs, std::size_t steps,
                         bool answer_is_alone) const {
  require_output(path_, inputs, answer_is_alone);
  check();
  if (path_.empty()) return;
  if (steps == 0 && time_option_.is_given())
    throw InvalidOptions("--time is of steps, and a single frame is named: leave it out, or name two frames");
  if (steps == 0 && !output().holds_pose)
    throw InvalidOptions(
        fmt::format("--out {}: such a file holds a step, not a single frame: name two frames, or write "
                    "html, png or csv",
                    printable(path_)));
  if (steps > 1 && !output().holds_sequence)
    throw InvalidOptions(fmt::format("--out {}: such a file holds one step, not {}: name two frames, or write html",
                                     printable(path_), steps));
}

void LookOutput::write(const io::Recording& recording) const {
  if (path_.empty()) return;
  const io::Output chosen = output();
  if (is_picture(chosen))
    io::write_picture(path_, recording, picture());
  else
    chosen.write(path_, recording);
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
