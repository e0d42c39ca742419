#include "files/format.hpp"

#include <algorithm>
#include <string>

#include "files/error.hpp"
#include "files/extension.hpp"

namespace tamis::io {
namespace {

/// ".csv, .html or .glb".
std::string joined(std::span<const std::string_view> extensions) {
  std::string text;
  for (std::size_t i = 0; i < extensions.size(); ++i) {
    if (i > 0) text += i + 1 < extensions.size() ? ", " : " or ";
    text += fmt::format(".{}", extensions[i]);
  }
  return text;
}

}  // namespace

std::size_t format_of(const std::filesystem::path& path, std::span<const std::string_view> extensions,
                      NoExtension without) {
  const std::string given = extension_of(path);
  if (given.empty() && without == NoExtension::is_first_format) return 0;
  const auto found = std::find_if(extensions.begin(), extensions.end(),
                                  [&](std::string_view extension) { return given == fmt::format(".{}", extension); });
  if (found != extensions.end()) return static_cast<std::size_t>(found - extensions.begin());
  const std::string which = given.empty() ? "without an extension" : fmt::format("as {}", given);
  throw FileError(path.string(), "",
                  fmt::format("nothing is written {} here: let the name end in {}", which, joined(extensions)));
}

}  // namespace tamis::io
