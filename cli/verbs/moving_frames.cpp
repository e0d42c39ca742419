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
  if (io::has_own_order(names)) note(kNaturalOrder);
  first_ = read_with_notes(paths_.front());
  // Two files stay as they were given, and their numbers say nothing.
  std::string doubt;
  for (std::size_t i = 1; i < paths_.size() && paths_.size() > 2 && doubt.empty(); ++i)
    if (doubt = io::doubt_about_order(paths_[i - 1], paths_[i]); !doubt.empty())
      note(fmt::format("{}: {}", paths_[i].string(), doubt));
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
