#include "files/mesh/frames.hpp"

#include <algorithm>
#include <optional>

#include "files/error.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/mesh/mesh_formats.hpp"
#include "files/mesh/wildcards.hpp"
#include "files/system.hpp"
#include "files/text.hpp"

namespace tamis::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the run of digits, or the single character, at the front.
std::string_view take_part(std::string_view& rest) {
  std::size_t size = 1;
  while (is_digit(rest[0]) && size < rest.size() && is_digit(rest[size])) ++size;
  const std::string_view part = rest.substr(0, size);
  rest.remove_prefix(size);
  return part;
}

std::string_view without_leading_zeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// Negative, zero or positive, as `a` comes before, with or after `b`. Numbers may have any length.
int compare_parts(std::string_view a, std::string_view b) {
  if (!is_digit(a[0]) || !is_digit(b[0])) return a.compare(b);
  a = without_leading_zeros(a);
  b = without_leading_zeros(b);
  return a.size() != b.size() ? (a.size() < b.size() ? -1 : 1) : a.compare(b);
}

std::vector<std::filesystem::path> mesh_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (std::error_code unknown; !it->is_directory(unknown) && is_mesh_name(it->path())) files.push_back(it->path());
  if (error) throw FileError(folder.string(), "", "the folder cannot be read: check its permissions");
  if (files.empty())
    throw FileError(folder.string(), "",
                    fmt::format("no {} file in this folder: give one that has some", mesh_format_names()));
  return files;
}

/// A number that ends a name, and the text before it.
struct Ending {
  std::string before;
  double number;
};

/// The number as people may mean it, with sign and decimals.
std::optional<Ending> ending_of(const std::filesystem::path& path) {
  const std::string name = (path.parent_path() / path.stem()).string();
  constexpr const char* kDigits = "0123456789";
  std::size_t first = name.find_last_not_of(kDigits) + 1;
  if (first == name.size()) return std::nullopt;
  if (first > 1 && name[first - 1] == '.' && is_digit(name[first - 2]))
    first = name.find_last_not_of(kDigits, first - 2) + 1;
  if (first > 0 && name[first - 1] == '-' && (first == 1 || name[first - 2] == '_' || name[first - 2] == '/')) --first;
  const std::optional<double> number = to_double(std::string_view(name).substr(first));
  if (!number) return std::nullopt;
  return Ending{name.substr(0, first), *number};
}

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const auto whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty())
    if (const int order = compare_parts(take_part(a), take_part(b)); order != 0) return order < 0;
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;  // a7 and a07: equal as numbers, yet the order must be fixed
}

std::vector<std::filesystem::path> paths_named(const std::string& name, const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path given = system::path_of(name), path = folder / given;
  if (std::filesystem::exists(path, error)) return {path};
  // Folders at its front that exist are no pattern, whatever characters they have.
  std::filesystem::path known = folder / given.root_path(), pattern;
  for (const auto& part : given.relative_path())
    if (pattern.empty() && std::filesystem::is_directory(known / part, error))
      known /= part;
    else
      pattern /= part;
  std::vector<std::filesystem::path> files = paths_matching(known, pattern, Brackets::are_sets);
  if (files.empty()) files = paths_matching(known, pattern, Brackets::are_plain);
  if (files.empty())
    throw FileError(path.string(), "", "no such file, and no file matches it as a pattern: check the path");
  return files;
}

std::vector<std::filesystem::path> frame_files(const std::vector<std::string>& names,
                                               const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const std::string& name : names) {
    for (const std::filesystem::path& path : paths_named(name, folder)) {
      const auto some = std::filesystem::is_directory(path, error) ? mesh_files_in(path) : std::vector{path};
      files.insert(files.end(), some.begin(), some.end());
    }
  }
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return natural_less(a.string(), b.string()); });
  return files;
}

bool has_own_order(const std::vector<std::string>& names, const std::filesystem::path& folder) {
  return names.size() > 2 && !std::is_sorted(names.begin(), names.end()) &&
         !std::is_sorted(names.begin(), names.end(), natural_less) &&
         std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return is_file(folder / system::path_of(name)); });
}

std::string doubt_about_order(const std::filesystem::path& before, const std::filesystem::path& file) {
  const std::optional<Ending> first = ending_of(before), second = ending_of(file);
  if (!first || !second || first->before != second->before || first->number <= second->number) return {};
  return fmt::format("it comes after {}: natural order knows neither decimals nor signs; number frames from 0 on",
                     before.filename().string());
}

std::vector<std::filesystem::path> moving_files(const std::vector<std::string>& names,
                                                const std::filesystem::path& folder) {
  if (names.size() == 2) {
    const std::filesystem::path first = folder / system::path_of(names[0]), second = folder / system::path_of(names[1]);
    if (is_file(first) && is_file(second)) return {first, second};
  }
  return frame_files(names, folder);
}

}  // namespace tamis::io
