// The frames of an animation, from what a user names on a command line.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tamis::io {

/// Runs of digits compare as numbers, so frame2 comes before frame10; everything else as bytes.
bool natural_less(std::string_view a, std::string_view b);

/// Files, folders (all PLY and OBJ files directly in them) and glob patterns, together in natural order. A name that
/// exists is never taken for a pattern. Throws FileError if one of them stands for no file.
std::vector<std::filesystem::path> frame_files(const std::vector<std::string>& names);

/// The paths a glob pattern stands for, unordered. Throws FileError if it matches nothing.
std::vector<std::filesystem::path> glob_files(const std::string& pattern);

}  // namespace tamis::io
