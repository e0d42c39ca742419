// A whole file in memory.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace tamis::io {

class FileBytes {
 public:
  /// Reads regular files, pipes and devices to their end. Throws FileError if it cannot.
  explicit FileBytes(const std::filesystem::path& path);

  std::string_view view() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace tamis::io
