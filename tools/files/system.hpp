// What files and the command need of the operating system beyond the standard library. The sources system_posix.cpp and
// system_windows.cpp alone know one. Functions that return false or null leave the reason in errno.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tamis::system {

/// The path that a text in UTF-8 names; on POSIX, any bytes. Windows' own conversions would take the text for one of
/// the system's code page. path.string() is the way back.
inline std::filesystem::path path_of(std::string_view text) {
  return std::filesystem::path(std::u8string(text.begin(), text.end()));
}

/// The words after the program's name: in UTF-8 on Windows, as they are elsewhere.
std::vector<std::string> words_of(int argc, char** argv);

/// To be called first. Opens each closed standard stream, so that reading finds the end and writing fails. Otherwise
/// the next file that is opened would get the stream's number, and notes would be written into a result. Lets no signal
/// end the program if a file may not grow. Lines end in LF everywhere.
void prepare_streams();

/// True if stderr is a terminal that obeys escape sequences.
bool stderr_is_terminal();

enum class Stream { out, err };
enum class Shared { nothing, file, pipe, device };

/// What the stream leads to, if the path leads there too.
Shared shared_by(Stream stream, const std::filesystem::path& path);

/// The time that processors have spent on the process, in all its threads. (On Windows std::clock() is a wall clock.)
double cpu_seconds();

/// The most memory that the process has had.
std::uint64_t peak_memory_bytes();

/// std::fopen for names with any characters.
std::FILE* open_file(const std::filesystem::path& path, const char* mode);

/// A link in /proc/PID/fd, to which /dev/stdout and /dev/fd/3 lead. Its text describes the open file, which need not
/// have a name.
bool is_descriptor(const std::filesystem::path& path);

/// A file that exists and is neither regular nor a folder: a pipe, a terminal, /dev/null, NUL.
bool is_stream(const std::filesystem::path& path);

/// True if a file that is there may be written.
bool is_writable(const std::filesystem::path& path);

/// Makes a file that must not be there yet, for writing. It is to replace `target`; if `target` is there, it takes over
/// its owner, group and permissions. If the owner or group cannot be kept, only the owner gets permissions: nobody may
/// do with the new file what they could not do with the old one.
std::FILE* make_part(const std::filesystem::path& path, const std::filesystem::path& target);

/// Waits until what the program has written is on the disk.
bool reach_disk(std::FILE* file);

}  // namespace tamis::system
