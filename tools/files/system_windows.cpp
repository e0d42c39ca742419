#define WIN32_LEAN_AND_MEAN
#if !defined(NOMINMAX)  // MinGW defines it itself
#define NOMINMAX
#endif
#define PSAPI_VERSION 2  // GetProcessMemoryInfo from kernel32
#include <windows.h>
// After windows.h, which they need.
#include <fcntl.h>
#include <io.h>
#include <psapi.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <cerrno>
#include <memory>

#include "files/system.hpp"

namespace tamis::system {
namespace {

namespace fs = std::filesystem;

struct CloseHandleOf {
  void operator()(void* handle) const { CloseHandle(handle); }
};
using Handle = std::unique_ptr<void, CloseHandleOf>;

/// The file, folder or device, to be looked at and neither read nor written; null if there is none.
Handle look_at(const fs::path& path) {
  constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  void* const handle =
      CreateFileW(path.c_str(), 0, kShared, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  return Handle(handle == INVALID_HANDLE_VALUE ? nullptr : handle);
}

bool are_same(void* a, void* b) {
  BY_HANDLE_FILE_INFORMATION of_a{}, of_b{};
  return GetFileInformationByHandle(a, &of_a) && GetFileInformationByHandle(b, &of_b) &&
         of_a.dwVolumeSerialNumber == of_b.dwVolumeSerialNumber && of_a.nFileIndexHigh == of_b.nFileIndexHigh &&
         of_a.nFileIndexLow == of_b.nFileIndexLow;
}

std::wstring wide(const char* ascii) { return {ascii, ascii + std::char_traits<char>::length(ascii)}; }

}  // namespace

std::vector<std::string> words_of(int /*argc*/, char** /*argv*/) {
  int count = 0;
  const std::unique_ptr<LPWSTR, decltype(&LocalFree)> words(CommandLineToArgvW(GetCommandLineW(), &count), &LocalFree);
  std::vector<std::string> texts;
  for (int i = 1; i < count; ++i) {
    const std::u8string text = fs::path(words.get()[i]).u8string();
    texts.emplace_back(text.begin(), text.end());
  }
  return texts;
}

void prepare_streams() {
  for (std::FILE* const stream : {stdin, stdout, stderr}) {
    if (_fileno(stream) < 0) std::freopen("NUL", "r", stream);
    _setmode(_fileno(stream), _O_BINARY);
  }
  SetConsoleOutputCP(CP_UTF8);
}

bool stderr_is_terminal() {
  void* const console = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  return GetConsoleMode(console, &mode) && SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

Shared shared_by(Stream stream, const fs::path& path) {
  void* const opened = GetStdHandle(stream == Stream::out ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
  const Handle named = look_at(path);
  if (!named || !are_same(opened, named.get())) return Shared::nothing;
  switch (GetFileType(opened)) {
    case FILE_TYPE_DISK:
      return Shared::file;
    case FILE_TYPE_PIPE:
      return Shared::pipe;
    default:
      return Shared::device;
  }
}

double cpu_seconds() {
  FILETIME begun{}, ended{}, kernel{}, user{};
  GetProcessTimes(GetCurrentProcess(), &begun, &ended, &kernel, &user);
  constexpr double kUnit = 1e-7, kWord = 0x1p32;
  const auto seconds = [](const FILETIME& t) { return (t.dwHighDateTime * kWord + t.dwLowDateTime) * kUnit; };
  return seconds(kernel) + seconds(user);
}

std::uint64_t peak_memory_bytes() {
  PROCESS_MEMORY_COUNTERS counters{};
  GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
  return counters.PeakWorkingSetSize;
}

std::FILE* open_file(const fs::path& path, const char* mode) { return _wfopen(path.c_str(), wide(mode).c_str()); }

bool is_descriptor(const fs::path& /*path*/) { return false; }

bool is_stream(const fs::path& path) {
  const Handle handle = look_at(path);
  return handle && GetFileType(handle.get()) != FILE_TYPE_DISK;
}

bool is_writable(const fs::path& path) {
  constexpr int kWrite = 2;
  return is_stream(path) || _waccess(path.c_str(), kWrite) == 0;
}

// A new file inherits the rights of its folder, as the old one did.
std::FILE* make_part(const fs::path& path, const fs::path& /*target*/) {
  const int descriptor =
      _wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
  return descriptor < 0 ? nullptr : _fdopen(descriptor, "wb");
}

bool reach_disk(std::FILE* file) { return _commit(_fileno(file)) == 0; }

}  // namespace tamis::system
