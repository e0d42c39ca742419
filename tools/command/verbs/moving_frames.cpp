#include "command/verbs/moving_frames.hpp"

#include <algorithm>

#include "command/command_line/messages.hpp"
#include "command/step_files.hpp"
#include "files/error.hpp"
#include "files/mesh/frames.hpp"
#include "files/motion/mesh_frames.hpp"

namespace tamis::cli {

MovingFrames::MovingFrames(const std::vector<std::string>& names, std::size_t least,
                           std::optional<double> weld_distance)
    : paths_(io::moving_files(names)), gaps_(io::gaps_between(paths_)) {
  if (paths_.size() < least)
    throw io::FileError(paths_.front().string(), "", "a single frame does not move: give two or more");
  first_ = read_with_notes(paths_.front());
  note_order(names);
  if (weld_distance) weld_all(*weld_distance);
}

/// Two files stay as they were given, and their numbers say nothing.
void MovingFrames::note_order(const std::vector<std::string>& names) const {
  if (io::has_own_order(names)) note(kNaturalOrder);
  std::string doubt;
  for (std::size_t i = 1; i < paths_.size() && paths_.size() > 2 && doubt.empty(); ++i)
    if (doubt = io::doubt_about_order(paths_[i - 1], paths_[i]); !doubt.empty())
      note(fmt::format("{}: {}", paths_[i].string(), doubt));
}

std::size_t MovingFrames::step_count() const {
  return static_cast<std::size_t>(std::ranges::count(gaps_.begin() + 1, gaps_.end(), std::string()));
}

void MovingFrames::note_gaps() const {
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (!follows(i)) note(fmt::format("{}: {}", paths_[i].string(), gaps_[i]));
}

void MovingFrames::require_no_gap() const {
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (!follows(i)) throw io::FileError(paths_[i].string(), "", gaps_[i] + "; give frames without a gap, or only two");
}

void MovingFrames::weld_all(double distance) {
  weld_.emplace(first_.positions.size(), distance);
  weld_->add_frame(first_.positions);
  const std::size_t at_first = weld_->joined_count();
  for (std::size_t i = 1; i < paths_.size(); ++i) {
    const io::MeshFile frame = io::read_mesh(paths_[i]);
    io::require_same_mesh(first_, paths_.front().string(), frame, paths_[i].string());
    weld_->add_frame(frame.positions);
  }
  weld_->apply_to(first_);
  note_weld(weld_->joined_count(), at_first);
}

std::vector<Point> MovingFrames::read(std::size_t i) const {
  io::MeshFile frame = io::read_mesh(paths_[i]);
  if (weld_ && weld_->first_of_vertex().size() == frame.positions.size()) weld_->apply_to(frame);
  io::require_same_mesh(first_, paths_.front().string(), frame, paths_[i].string());
  for (const std::string& sentence : frame.notes_of_later_frame())
    if (std::find(first_.notes.begin(), first_.notes.end(), sentence) == first_.notes.end())
      note(fmt::format("{}: {}", paths_[i].string(), sentence));
  return std::move(frame.positions);
}

}  // namespace tamis::cli
