#include "files/file_bytes.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "files/error.hpp"
#include "files/system.hpp"

namespace tamis::io {
namespace {

[[noreturn]] void refuse_to_read(const std::filesystem::path& path, int error) {
  const bool is_address = path.string().find("://") != std::string::npos;
  throw FileError(path.string(), "",
                  fmt::format("cannot be read ({}): {}", std::generic_category().message(error),
                              is_address ? "give a path (package:// of a URDF stands for a folder)"
                                         : "check the path and its permissions"));
}

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& path) {
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(system::open_file(path, "rb"), close);
  if (!file) refuse_to_read(path, errno);
  std::error_code is_no_regular_file;
  const auto size = std::filesystem::file_size(path, is_no_regular_file);
  // One byte more than the file has, so that a single read meets its end.
  constexpr std::size_t kFirstRead = std::size_t{1} << 16;
  std::size_t room = is_no_regular_file ? kFirstRead : static_cast<std::size_t>(size) + 1;
  std::size_t used = 0;
  for (;;) {
    bytes_.resize(used + room);
    const std::size_t got = std::fread(bytes_.data() + used, 1, room, file.get());
    used += got;
    if (std::ferror(file.get())) refuse_to_read(path, errno);
    if (got < room) break;
    room = used;
  }
  bytes_.resize(used);
}

}  // namespace tamis::io
