// An output file that appears complete or not at all.
#pragma once
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace tamis::io {

/// Writes NAME.XXXXXXXX.part beside the final file; `commit` renames it. Without `commit` the old file stays as it was,
/// and the destructor removes the part. A process that is killed leaves its part behind; nothing ever reads it. The new
/// file has the permissions of the file it replaces, and its owner as far as the system allows. Symbolic links are
/// followed, also to a name that no file has yet. A pipe or device is written directly; so is the open file of a
/// descriptor (/dev/stdout, /dev/fd/3), at its end.
class AtomicFile {
 public:
  /// Throws FileError if the file cannot be made or replaced.
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Errors show up in `commit`.
  void append(std::string_view bytes);
  /// Throws FileError if not every byte reached the disk.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void open_part();

  std::filesystem::path path_;    ///< as the user named it
  std::filesystem::path target_;  ///< the file that is replaced, at the end of all symbolic links
  std::filesystem::path part_;    ///< the file that is written and not yet renamed; empty: none
  std::unique_ptr<std::FILE, Close> file_;
  int error_ = 0;  ///< errno of the first failure; 0: none
};

/// Throws FileError if the file cannot be written; leaves no file behind. For a check before a long computation.
void require_writable(const std::filesystem::path& path);

/// Makes a folder for output, with those above it; it may be there already. Throws FileError if that fails.
void make_folder(const std::filesystem::path& path);

}  // namespace tamis::io
