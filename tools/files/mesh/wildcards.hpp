// Patterns of names, as a shell has them: Windows' shells leave them to the programs.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace tamis::io {

/// What [a-z] in a pattern stands for: one character of the set ([!a-z]: one of all others), or itself.
enum class Brackets { are_sets, are_plain };

/// True if the whole name matches: * stands for any characters, ? for one byte, \c for the character c.
bool matches(std::string_view pattern, std::string_view name, Brackets brackets);

/// The files and folders below `folder` that match; each part of the path is a pattern. Hidden ones match only a
/// pattern that begins with a point. In no order.
std::vector<std::filesystem::path> paths_matching(const std::filesystem::path& folder,
                                                  const std::filesystem::path& pattern, Brackets brackets);

}  // namespace tamis::io
