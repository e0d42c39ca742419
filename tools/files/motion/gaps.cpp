#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "files/motion/mesh_frames.hpp"

namespace tamis::io {
namespace {

/// The last number in a name, and the text before it.
struct Numbered {
  std::string before;
  std::int64_t number;
};

std::optional<Numbered> numbered(const std::filesystem::path& path) {
  const std::string name = path.string();
  const std::size_t last = name.find_last_of("0123456789", name.size() - path.extension().string().size());
  if (last == std::string::npos) return std::nullopt;
  const std::size_t first = name.find_last_not_of("0123456789", last) + 1;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(name.data() + first, name.data() + last + 1, number);
  if (error != std::errc()) return std::nullopt;
  return Numbered{name.substr(0, first), number};
}

/// The number in b less the number in a; 0 if one has no number or the texts before the numbers differ.
std::int64_t difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::optional<Numbered> first = numbered(a), second = numbered(b);
  return first && second && first->before == second->before ? second->number - first->number : 0;
}

std::string missing(const std::filesystem::path& before, std::int64_t leap, std::int64_t stride) {
  const std::int64_t number = numbered(before)->number;
  const std::int64_t count = leap / stride - 1;
  return count == 1 ? fmt::format("frame {} is missing before this one: no step leads here", number + stride)
                    : fmt::format("frames {} to {} are missing before this one: no step leads here", number + stride,
                                  number + count * stride);
}

}  // namespace

std::vector<std::string> gaps_between(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> gaps(paths.size());
  std::int64_t stride = 0;
  for (std::size_t i = 1; i < paths.size(); ++i)
    if (const std::int64_t leap = difference(paths[i - 1], paths[i]); leap > 0)
      stride = stride == 0 ? leap : std::min(stride, leap);
  for (std::size_t i = 1; i < paths.size(); ++i)
    if (const std::int64_t leap = difference(paths[i - 1], paths[i]); stride > 0 && leap / stride >= 2)
      gaps[i] = missing(paths[i - 1], leap, stride);
  return gaps;
}

}  // namespace tamis::io
