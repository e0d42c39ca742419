// The viewer with a recording in it, as one HTML file.
#pragma once
#include <filesystem>

#include "files/view/recording.hpp"

namespace tamis::io {

/// Atomically. Works without a network and without a server. Throws io::FileError.
void write_viewer_page(const std::filesystem::path& path, const Recording& recording);

}  // namespace tamis::io
