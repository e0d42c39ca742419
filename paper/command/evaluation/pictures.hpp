// The pictures of tamis-lab paper, drawn by a script in Python with matplotlib.
#pragma once
#include <filesystem>
#include <string>

namespace tamis::lab {

/// Draws table1.png, fig4.png and fig5.png from the tables in `folder`. Returns an empty string if it did, otherwise
/// why not and what to do.
std::string draw_pictures(const std::filesystem::path& folder);

}  // namespace tamis::lab
