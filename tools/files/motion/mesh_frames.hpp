// A motion whose frames are mesh files.
#pragma once
#include <filesystem>
#include <vector>

#include "audit/frame_source.hpp"
#include "files/mesh/mesh_file.hpp"

namespace tamis::io {

/// Each file is read when it is asked for. No step leads to a frame if its topology is new, or if numbers are missing
/// between its file name and the one before.
class MeshFrames final : public audit::FrameSource {
 public:
  /// REQUIRES: at least one path. Throws FileError if the first cannot be used.
  MeshFrames(std::vector<std::filesystem::path> paths, audit::Objects objects);

  audit::FramePointer next() override;
  std::size_t count() const override { return paths_.size(); }

 private:
  audit::FramePointer frame_of(const std::filesystem::path& path);

  std::vector<std::filesystem::path> paths_;
  std::vector<std::string> gaps_;  ///< for each path: a sentence on the frames missing before it, or empty
  audit::Objects objects_;
  std::size_t next_ = 0;
  MeshFile last_;  ///< topology alone
  std::shared_ptr<const audit::AuditedMesh> mesh_;
  audit::FramePointer first_;
};

/// For each file, in their order, a sentence on the frames that are missing before it, or an empty one. A file's number
/// is the last digits of its name; the smallest difference of two successive numbers counts as one frame.
std::vector<std::string> gaps_between(const std::vector<std::filesystem::path>& paths);

}  // namespace tamis::io
