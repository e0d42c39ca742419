// The viewer with a recording in it, as one HTML file.
#pragma once
#include <filesystem>

#include "cli/view/recording.hpp"

namespace tamis::cli {

/// Atomically. Works without a network and without a server. Throws io::FileError.
void write_viewer_page(const std::filesystem::path& path, const Recording& recording);

}  // namespace tamis::cli
