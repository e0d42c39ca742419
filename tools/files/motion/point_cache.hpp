// Point caches: where each vertex of one mesh is, frame after frame, in floats. PC2 and MDD.
#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "audit/frame_source.hpp"

namespace tamis::io {

/// Does the name end as those of point caches do?
bool is_point_cache_name(const std::filesystem::path& path);

/// The data before the positions.
struct PointCacheHeader {
  std::uint32_t vertices = 0;
  std::uint32_t frames = 0;
  std::vector<std::string> names;  ///< of the frames, by their times
  bool is_big_endian = false;
  std::vector<std::string> notes = {};  ///< on each frame, or none at all
};

/// A frame is read when it is asked for: the file may be larger than the memory.
class PointCache final : public audit::FrameSource {
 public:
  /// Throws FileError if it cannot be read, or is no cache of this mesh.
  PointCache(const std::filesystem::path& path, std::shared_ptr<const audit::AuditedMesh> mesh);

  audit::FramePointer next() override;
  std::size_t count() const override { return header_.frames; }

 private:
  bool read(std::vector<Point>& positions);
  /// If bytes follow the last frame, a frame whose `problem` says so; otherwise null.
  audit::FramePointer what_is_left();

  std::ifstream file_;
  PointCacheHeader header_;
  std::shared_ptr<const audit::AuditedMesh> mesh_;
  std::uint32_t next_ = 0;
  bool has_ended_ = false;
};

}  // namespace tamis::io
