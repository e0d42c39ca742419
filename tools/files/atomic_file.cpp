#include "files/atomic_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include "files/error.hpp"
#include "files/system.hpp"

namespace tamis::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_to_write(const fs::path& path, const std::error_code& error) {
  throw FileError(
      path.string(), "",
      fmt::format("cannot be written ({}): check the path, its permissions and the free space", error.message()));
}

/// `error`: of errno.
[[noreturn]] void refuse_to_write(const fs::path& path, int error) {
  refuse_to_write(path, std::error_code(error, std::generic_category()));
}

bool is_written_directly(const fs::path& target) { return system::is_stream(target) || system::is_descriptor(target); }

/// The name at the end of all symbolic links, or the link of a descriptor. No file need have that name.
fs::path behind_links(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  fs::path name = path;
  std::error_code error;
  for (int i = 0; i < kMostLinks; ++i) {
    if (system::is_descriptor(name) || !fs::is_symlink(name, error)) return name;
    name = name.parent_path() / fs::read_symlink(name, error);
    if (error) refuse_to_write(path, error);
  }
  refuse_to_write(path, ELOOP);
}

/// The final name, digits that make it unique, ".part". The longest names are cut.
fs::path name_of_part(const fs::path& target) {
  constexpr std::size_t kLongest = 255;  // of Linux, macOS and Windows
  const std::string ending = fmt::format(".{:08x}.part", std::random_device()());
  fs::path name = target.filename().native().substr(0, kLongest - ending.size());
  return target.parent_path() / (name += ending);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(behind_links(path)) {
  std::error_code error;
  if (target_.empty()) refuse_to_write(path, ENOENT);
  if (fs::is_directory(target_, error)) refuse_to_write(path, EISDIR);
  if (is_written_directly(target_))
    file_.reset(system::open_file(target_, "ab"));  // appends: a descriptor's file keeps its content
  else
    open_part();
  if (!file_) refuse_to_write(path_, errno);
}

AtomicFile::~AtomicFile() {
  file_.reset();  // Windows removes no file that is open
  std::error_code error;
  if (!part_.empty()) fs::remove(part_, error);
}

void AtomicFile::open_part() {
  std::error_code error;
  // A rename would succeed in spite of the old file's write protection.
  if (fs::exists(target_, error) && !system::is_writable(target_)) refuse_to_write(path_, errno);
  const fs::path name = name_of_part(target_);
  file_.reset(system::make_part(name, target_));
  if (file_) part_ = name;
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
  if (error_ == 0 && !part_.empty() && !system::reach_disk(file_.get())) error_ = errno;
  if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = errno;
  if (error_ != 0) refuse_to_write(path_, error_);
  if (part_.empty()) return;
  std::error_code error;
  fs::rename(part_, target_, error);
  if (error) refuse_to_write(path_, error);
  part_.clear();
}

void require_writable(const fs::path& path) {
  const fs::path target = behind_links(path);
  if (!is_written_directly(target))
    AtomicFile{path};
  else if (!system::is_writable(target))
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
