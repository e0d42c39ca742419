// The files of an animation's frames, from the names that a user gives on a command line.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tamis::io {

/// Runs of digits compare as numbers, so frame2 comes before frame10; everything else as bytes.
bool natural_less(std::string_view a, std::string_view b);

/// Files, folders (all mesh files directly in them) and glob patterns, together in natural order. A name that
/// exists is never taken for a pattern, nor is `folder`, in which the names are looked for. Throws FileError if one of
/// them stands for no file.
std::vector<std::filesystem::path> frame_files(const std::vector<std::string>& names,
                                               const std::filesystem::path& folder = {});

/// The frames of a motion: as frame_files, but two files stay in the order in which they are given.
std::vector<std::filesystem::path> moving_files(const std::vector<std::string>& names,
                                                const std::filesystem::path& folder = {});

/// Are the names files in an order of the caller's own, which natural order changes? The order of bytes, which a shell
/// gives to the files of a pattern, is none of the caller's own; two files are never sorted.
bool has_own_order(const std::vector<std::string>& names, const std::filesystem::path& folder = {});

/// A sentence if natural order puts `file` behind `before` though its number is smaller, read with a sign behind '_' or
/// '/' and with decimals: 0.5 before 0.25, _-1 before _-2. Otherwise empty.
std::string doubt_about_order(const std::filesystem::path& before, const std::filesystem::path& file);

/// The path `name` in `folder` if it exists, otherwise all paths there that match it as a glob pattern, unordered.
/// Throws FileError if no path matches.
std::vector<std::filesystem::path> paths_named(const std::string& name, const std::filesystem::path& folder = {});

}  // namespace tamis::io
