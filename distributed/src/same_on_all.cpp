#include "distributed/src/same_on_all.hpp"

#include <array>
#include <charconv>

#include "distributed/src/agreement.hpp"
#include "tamis/error.hpp"

namespace tamis::distributed {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// The line of `text` that starts at `first`.
std::string line_at(const std::string& text, std::size_t first) {
  return text.substr(first, text.find('\n', first) - first);
}

}  // namespace

void require_same(Communicator& communicator, const std::vector<std::string>& sayings) {
  const std::string mine = joined(sayings);
  Bytes bytes;
  for (const char c : mine) bytes.push_back(static_cast<std::byte>(c));
  communicator.broadcast(bytes, 0);
  std::string theirs;
  for (const std::byte b : bytes) theirs += static_cast<char>(b);
  together(communicator, [&] {
    for (std::size_t a = 0, b = 0; a < mine.size() || b < theirs.size();) {
      const std::string here = line_at(mine, a), there = line_at(theirs, b);
      if (here != there)
        throw InvalidOptions(std::string("here it is '").append(here).append("', on rank 0 '").append(there) +
                             "': say the same on all ranks");
      a += here.size() + 1;
      b += there.size() + 1;
    }
  });
}

std::vector<std::string> sayings_of(const Options& options) {
  std::vector<std::string> sayings{"min_separation " + exact(options.min_separation),
                                   "group_count " + std::to_string(options.filter.group_count)};
  std::string radii = "radii", touch = "groups_may_touch";
  for (const double radius : options.radii) radii.append(" ").append(exact(radius));
  for (const std::uint8_t flag : options.filter.groups_may_touch) touch += flag != 0 ? " 1" : " 0";
  sayings.push_back(radii);
  sayings.push_back(touch);
  sayings.emplace_back(options.filter.accepts ? "a function in filter.accepts" : "no function in filter.accepts");
  return sayings;
}

std::string exact(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number + 0.0).ptr;
  return {text.data(), end};
}

}  // namespace tamis::distributed
