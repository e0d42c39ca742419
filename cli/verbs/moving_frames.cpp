#include "cli/verbs/moving_frames.hpp"

#include <algorithm>

#include "cli/command_line/messages.hpp"
#include "cli/step_files.hpp"
#include "io/error.hpp"
#include "io/mesh/frames.hpp"

namespace tamis::cli {

MovingFrames::MovingFrames(const std::vector<std::string>& names, std::size_t least) : paths_(io::moving_files(names)) {
  if (paths_.size() < least)
    throw io::FileError(paths_.front().string(), "", "a single frame does not move: give two or more");
  first_ = read_with_notes(paths_.front());
}

std::vector<Point> MovingFrames::read(std::size_t i) const {
  io::MeshFile frame = io::read_mesh(paths_[i]);
  io::require_same_mesh(first_, paths_.front().string(), frame, paths_[i].string());
  for (const std::string& sentence : frame.notes)
    if (std::find(first_.notes.begin(), first_.notes.end(), sentence) == first_.notes.end())
      note(fmt::format("{}: {}", paths_[i].string(), sentence));
  return std::move(frame.positions);
}

}  // namespace tamis::cli
