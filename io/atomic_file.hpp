// An output file that appears complete or not at all.
#pragma once
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace tamis::io {

/// Writes beside the final place under a temporary name; `commit` renames it. Without `commit` the file that was there
/// stays as it was. A pipe or device is written directly.
class AtomicFile {
 public:
  /// Throws FileError if the file cannot be made or replaced.
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Errors show up in `commit`.
  void append(std::string_view bytes);
  /// Throws FileError if not every byte reached the file system.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path path_;    ///< as the user named it
  std::filesystem::path target_;  ///< what is replaced: behind all symbolic links
  std::filesystem::path temporary_;
  std::unique_ptr<std::FILE, Close> file_;
  bool failed_ = false;
};

/// Throws FileError if the file could not be written; nothing stays behind. For asking before a long computation.
void require_writable(const std::filesystem::path& path);

/// Makes a folder for output, with those above it; it may be there already. Throws FileError if that fails.
void make_folder(const std::filesystem::path& path);

}  // namespace tamis::io
