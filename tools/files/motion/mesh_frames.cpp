#include "files/motion/mesh_frames.hpp"

#include <algorithm>

#include "files/error.hpp"
#include "files/mesh/frames.hpp"

namespace tamis::io {
namespace {

std::string joined(std::span<const std::string> sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
  return text;
}

}  // namespace

MeshFrames::MeshFrames(std::vector<std::filesystem::path> paths, audit::Objects objects)
    : paths_(std::move(paths)), gaps_(gaps_between(paths_)), objects_(std::move(objects)) {
  first_ = frame_of(paths_.front());
}

audit::FramePointer MeshFrames::next() {
  if (next_ == paths_.size()) return nullptr;
  const std::size_t i = next_++;
  if (i == 0) return std::exchange(first_, nullptr);
  audit::Frame frame;
  try {
    frame = *frame_of(paths_[i]);
  } catch (const FileError& error) {
    frame.name = paths_[i].filename().string();
    frame.problem = error.what();
  }
  const std::string doubt = paths_.size() > 2 ? doubt_about_order(paths_[i - 1], paths_[i]) : "";
  for (const std::string& sentence : {gaps_[i], doubt})
    if (!sentence.empty()) frame.note += (frame.note.empty() ? "" : "; ") + sentence;
  frame.follows = gaps_[i].empty();
  return std::make_shared<const audit::Frame>(std::move(frame));
}

audit::FramePointer MeshFrames::frame_of(const std::filesystem::path& path) {
  MeshFile file = read_mesh(path);
  std::vector<Point> positions = std::move(file.positions);
  file.positions.clear();
  const bool is_new = !mesh_ || positions.size() != static_cast<std::size_t>(mesh_->mesh().vertex_count()) ||
                      !has_topology_of(last_, file);
  const auto said = is_new ? std::span<const std::string>(file.notes) : file.notes_of_later_frame();
  const bool is_known = !is_new && std::ranges::equal(said, last_.notes_of_later_frame());
  const std::string note = is_known ? "" : joined(said);
  if (is_new) {
    last_ = file;
    file.positions.resize(positions.size());
    mesh_ = std::make_shared<audit::AuditedMesh>(mesh_of(std::move(file)), objects_);
  }
  return std::make_shared<const audit::Frame>(
      audit::Frame{path.filename().string(), std::move(positions), mesh_, {}, note});
}

}  // namespace tamis::io
