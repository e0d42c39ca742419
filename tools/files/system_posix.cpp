#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>

#include "files/system.hpp"

namespace tamis::system {
namespace {

namespace fs = std::filesystem;

/// Gives the new file the owner, group and mode of the file that it replaces, as make_part says.
bool take_over(const struct stat& old, int descriptor) {
  constexpr mode_t kPermissions = 0777, kOfOwner = 0700;
  struct stat made {};
  if (fstat(descriptor, &made) != 0) return true;
  const bool is_same = made.st_uid == old.st_uid && made.st_gid == old.st_gid;
  const bool is_kept = is_same || fchown(descriptor, old.st_uid, old.st_gid) == 0;
  return fchmod(descriptor, old.st_mode & (is_kept ? kPermissions : kOfOwner)) == 0 || errno == EPERM;
}

}  // namespace

std::vector<std::string> words_of(int argc, char** argv) { return {argv + (argc > 0 ? 1 : 0), argv + argc}; }

void prepare_streams() {
  // open() gives the lowest free number, so those below are taken already.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDONLY) < 0) break;
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large (ulimit -f) is an error of writing
}

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

Shared shared_by(Stream stream, const fs::path& path) {
  struct stat of_stream {
  }, of_path{};
  const int descriptor = stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO;
  if (fstat(descriptor, &of_stream) != 0 || stat(path.c_str(), &of_path) != 0 || of_stream.st_dev != of_path.st_dev ||
      of_stream.st_ino != of_path.st_ino)
    return Shared::nothing;
  if (S_ISREG(of_path.st_mode)) return Shared::file;
  return S_ISFIFO(of_path.st_mode) || S_ISSOCK(of_path.st_mode) ? Shared::pipe : Shared::device;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
  constexpr std::uint64_t kUnit = 1;
#else
  constexpr std::uint64_t kUnit = 1024;
#endif
  return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

std::FILE* open_file(const fs::path& path, const char* mode) { return std::fopen(path.c_str(), mode); }

bool is_descriptor(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(path.parent_path(), error);
  return !error && folder.filename() == "fd" && folder.string().starts_with("/proc/");
}

bool is_stream(const fs::path& path) {
  std::error_code error;
  return fs::is_other(path, error) && !error;
}

bool is_writable(const fs::path& path) { return access(path.c_str(), W_OK) == 0; }

std::FILE* make_part(const fs::path& path, const fs::path& target) {
  constexpr mode_t kUsual = 0666, kPrivate = 0600;
  struct stat old {};
  const bool replaces = stat(target.c_str(), &old) == 0;
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? kPrivate : kUsual);
  if (descriptor < 0) return nullptr;
  if (replaces && !take_over(old, descriptor)) {
    const int reason = errno;
    close(descriptor);
    unlink(path.c_str());
    errno = reason;
    return nullptr;
  }
  return fdopen(descriptor, "wb");
}

bool reach_disk(std::FILE* file) { return fsync(fileno(file)) == 0; }

}  // namespace tamis::system
