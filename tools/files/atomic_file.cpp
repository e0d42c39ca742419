#include "files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include "files/error.hpp"

namespace tamis::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_to_write(const fs::path& path, int error) {
  throw FileError(path.string(), "",
                  fmt::format("cannot be written ({}): check the path, its permissions and the free space",
                              std::generic_category().message(error)));
}

/// A file that exists and is neither regular nor a folder: a pipe, a terminal, /dev/null.
bool is_stream(const fs::path& path) {
  std::error_code error;
  return fs::is_other(path, error) && !error;
}

/// A link in /proc/PID/fd, to which /dev/stdout and /dev/fd/3 lead. Its text describes the open file, which need not
/// have a name.
bool is_descriptor(const fs::path& name) {
  std::error_code error;
  const fs::path folder = fs::canonical(name.parent_path(), error);
  return !error && folder.filename() == "fd" && folder.string().starts_with("/proc/");
}

bool is_written_directly(const fs::path& target) { return is_stream(target) || is_descriptor(target); }

/// The name at the end of all symbolic links, or the link of a descriptor. No file need have that name.
fs::path behind_links(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  fs::path name = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks; ++i) {
    if (is_descriptor(name) || !fs::is_symlink(name, error)) return name;
    name = name.parent_path() / fs::read_symlink(name, error);
    if (error) refuse_to_write(path, error.value());
  }
  refuse_to_write(path, ELOOP);
}

/// Gives the new file the owner, group and mode of the file that it replaces. If the owner or group cannot be kept,
/// only the owner gets permissions: nobody may do with the new file what they could not do with the old one.
void take_over(const struct stat& old, int descriptor) {
  constexpr mode_t kPermissions = 0777, kOfOwner = 0700;
  struct stat made {};
  if (fstat(descriptor, &made) != 0) return;
  const bool is_same = made.st_uid == old.st_uid && made.st_gid == old.st_gid;
  const bool is_kept = is_same || fchown(descriptor, old.st_uid, old.st_gid) == 0;
  if (fchmod(descriptor, old.st_mode & (is_kept ? kPermissions : kOfOwner)) != 0 && errno != EPERM)
    throw std::system_error(errno, std::generic_category());
}

/// The final name, digits that make it unique, ".part". The longest names are cut.
std::string name_of_part(const fs::path& target) {
  const std::string ending = fmt::format(".{:08x}.part", std::random_device()());
  return (target.parent_path() / (target.filename().string().substr(0, NAME_MAX - ending.size()) + ending)).string();
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(behind_links(path)) {
  std::error_code error;
  if (target_.empty()) refuse_to_write(path, ENOENT);
  if (fs::is_directory(target_, error)) refuse_to_write(path, EISDIR);
  try {
    if (is_written_directly(target_))
      file_.reset(std::fopen(target_.c_str(), "ab"));  // appends: a descriptor's file keeps its content
    else
      open_part();
  } catch (const std::system_error& failure) {
    refuse_to_write(path_, failure.code().value());
  }
  if (!file_) refuse_to_write(path_, errno);
}

AtomicFile::~AtomicFile() {
  if (!part_.empty()) unlink(part_.c_str());
}

void AtomicFile::open_part() {
  struct stat old {};
  const bool replaces = stat(target_.c_str(), &old) == 0;
  // A rename would succeed in spite of the old file's write protection.
  if (replaces && access(target_.c_str(), W_OK) != 0) refuse_to_write(path_, errno);
  constexpr mode_t kUsual = 0666, kPrivate = 0600;
  const std::string name = name_of_part(target_);
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? kPrivate : kUsual);
  if (descriptor < 0) throw std::system_error(errno, std::generic_category());
  part_ = name;
  file_.reset(fdopen(descriptor, "wb"));
  if (replaces) take_over(old, descriptor);
}

void AtomicFile::append(std::string_view bytes) {
  if (error_ != 0) return;
  errno = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size()) return;
  error_ = errno != 0 ? errno : EIO;
}

void AtomicFile::commit() {
  if (error_ == 0 && std::fflush(file_.get()) != 0) error_ = errno;
  // Otherwise a power cut could lose the data but keep the new name: half a file after all.
  if (error_ == 0 && !part_.empty() && fsync(fileno(file_.get())) != 0) error_ = errno;
  if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = errno;
  if (error_ != 0) refuse_to_write(path_, error_);
  if (part_.empty()) return;
  if (std::rename(part_.c_str(), target_.c_str()) != 0) refuse_to_write(path_, errno);
  part_.clear();
}

void require_writable(const fs::path& path) {
  const fs::path target = behind_links(path);
  if (!is_written_directly(target))
    AtomicFile{path};
  else if (access(target.c_str(), W_OK) != 0)
    refuse_to_write(path, errno);
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw FileError(path.string(), "",
                    fmt::format("the folder cannot be made ({}): check the path and its permissions", error.message()));
}

}  // namespace tamis::io
