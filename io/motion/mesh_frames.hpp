// A motion whose frames are mesh files.
#pragma once
#include <filesystem>
#include <vector>

#include "audit/frame_source.hpp"
#include "io/mesh/mesh_file.hpp"

namespace tamis::io {

/// Each file is read when it is asked for. Where the topology changes, or where a number in the names leaps, no step
/// leads on.
class MeshFrames final : public audit::FrameSource {
 public:
  /// REQUIRES: at least one path. Throws FileError if the first cannot be used.
  MeshFrames(std::vector<std::filesystem::path> paths, audit::Objects objects);

  audit::FramePointer next() override;
  std::size_t count() const override { return paths_.size(); }

 private:
  audit::FramePointer frame_of(const std::filesystem::path& path);

  std::vector<std::filesystem::path> paths_;
  std::vector<std::string> gaps_;  ///< one a path: what is missing before it
  audit::Objects objects_;
  std::size_t next_ = 0;
  MeshFile last_;  ///< topology alone
  std::shared_ptr<const audit::AuditedMesh> mesh_;
  audit::FramePointer first_;
};

/// Of each file, in their order: which ones are missing before it, as a sentence, or nothing. Files are numbered by the
/// last digits of their names, and go on by the smallest difference that occurs.
std::vector<std::string> gaps_between(const std::vector<std::filesystem::path>& paths);

}  // namespace tamis::io
