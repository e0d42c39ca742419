#include "files/mesh/wildcards.hpp"

#include <cstddef>
#include <string>
#include <system_error>

#include "files/system.hpp"

namespace tamis::io {
namespace {

namespace fs = std::filesystem;

/// A set of characters at the front of a pattern.
struct CharacterSet {
  std::size_t size = 0;  ///< of its text; 0: no bracket closes it
  bool has = false;      ///< it has the character
};

CharacterSet look_into_set(std::string_view pattern, unsigned char c) {
  const bool is_negated = pattern.size() > 1 && (pattern[1] == '!' || pattern[1] == '^');
  const std::size_t begin = is_negated ? 2 : 1;
  bool is_in = false;
  std::size_t i = begin;
  for (; i < pattern.size() && (i == begin || pattern[i] != ']'); ++i) {
    const auto first = static_cast<unsigned char>(pattern[i]);
    const bool is_range = i + 2 < pattern.size() && pattern[i + 1] == '-' && pattern[i + 2] != ']';
    if (is_range) i += 2;
    is_in |= first <= c && c <= static_cast<unsigned char>(pattern[i]);
  }
  return {i < pattern.size() ? i + 1 : 0, is_in != is_negated};
}

/// Takes what stands for one character off the front of the pattern; true if it matches `c`.
bool take_one(std::string_view& pattern, char c, Brackets brackets) {
  if (pattern.empty()) return false;
  if (pattern[0] == '[' && brackets == Brackets::are_sets)
    if (const CharacterSet set = look_into_set(pattern, static_cast<unsigned char>(c)); set.size > 0) {
      pattern.remove_prefix(set.size);
      return set.has;
    }
  const bool is_any = pattern[0] == '?';
  if (pattern[0] == '\\' && pattern.size() > 1) pattern.remove_prefix(1);
  const char wanted = pattern[0];
  pattern.remove_prefix(1);
  return is_any || wanted == c;
}

std::vector<fs::path> matches_in(const fs::path& folder, const std::string& pattern, Brackets brackets) {
  std::error_code error;
  if (pattern.find_first_of("*?[\\") == std::string::npos) {
    const fs::path path = folder / system::path_of(pattern);
    return fs::exists(fs::symlink_status(path, error)) ? std::vector{path} : std::vector<fs::path>();
  }
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path name = it->path().filename();
    const std::string text = name.string();
    if (matches(pattern, text, brackets) && (text[0] != '.' || pattern[0] == '.')) found.push_back(folder / name);
  }
  return found;
}

}  // namespace

bool matches(std::string_view pattern, std::string_view name, Brackets brackets) {
  bool has_star = false;
  std::string_view behind_star, rest;  // the last star takes all before `rest`
  while (!pattern.empty() || !name.empty()) {
    if (pattern.starts_with('*')) {
      pattern.remove_prefix(1);
      has_star = true;
      behind_star = pattern;
      rest = name;
    } else if (!name.empty() && take_one(pattern, name[0], brackets)) {
      name.remove_prefix(1);
    } else {
      if (!has_star || rest.empty()) return false;
      rest.remove_prefix(1);
      name = rest;
      pattern = behind_star;
    }
  }
  return true;
}

std::vector<fs::path> paths_matching(const fs::path& folder, const fs::path& pattern, Brackets brackets) {
  std::vector<fs::path> found{folder};
  for (const fs::path& part : pattern) {
    std::vector<fs::path> deeper;
    for (const fs::path& above : found)
      for (fs::path& path : matches_in(above, part.string(), brackets)) deeper.push_back(std::move(path));
    found = std::move(deeper);
  }
  return found;
}

}  // namespace tamis::io
