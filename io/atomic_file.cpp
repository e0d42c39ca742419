#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "io/error.hpp"

namespace tamis::io {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw FileError(path.string(), "",
                  fmt::format("cannot be written ({}): check the path, its permissions and the free space",
                              std::generic_category().message(error)));
}

/// A file that exists and is neither regular nor a folder: a pipe, a terminal, /dev/null.
bool is_stream(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_other(path, error) && !error;
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path) {
  std::error_code error;
  target_ = std::filesystem::weakly_canonical(path, error);
  if (error) target_ = path;
  if (std::filesystem::is_directory(target_, error)) fail(path, EISDIR);
  if (is_stream(target_)) {
    file_.reset(std::fopen(target_.c_str(), "wb"));
  } else {
    // Renaming would get past a file's own write protection.
    if (std::filesystem::exists(target_, error) && access(target_.c_str(), W_OK) != 0) fail(path, errno);
    temporary_ = fmt::format("{}.part{}", target_.string(), getpid());
    const int descriptor = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) file_.reset(fdopen(descriptor, "wb"));
  }
  if (!file_) fail(path, errno);
}

AtomicFile::~AtomicFile() {
  std::error_code error;
  if (file_ && !temporary_.empty()) std::filesystem::remove(temporary_, error);
}

void AtomicFile::append(std::string_view bytes) {
  if (!failed_ && std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) failed_ = true;
}

void AtomicFile::commit() {
  if (failed_ || std::fflush(file_.get()) != 0) fail(path_, errno ? errno : EIO);
  std::error_code error;
  if (!temporary_.empty()) std::filesystem::rename(temporary_, target_, error);
  if (error) fail(path_, error.value());
  file_.reset();
}

void require_writable(const std::filesystem::path& path) {
  if (!is_stream(path)) AtomicFile{path};
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error)
    throw FileError(path.string(), "",
                    fmt::format("the folder cannot be made ({}): check the path and its permissions", error.message()));
}

}  // namespace tamis::io
