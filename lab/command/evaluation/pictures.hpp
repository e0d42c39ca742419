// The pictures of tamis-lab paper, drawn by a script in Python with matplotlib.
#pragma once
#include <filesystem>
#include <string>

namespace tamis::lab {

/// Draws table1.png, fig4.png and fig5.png from the tables in `folder`. Returns why there are none, and what to do;
/// empty if there are.
std::string draw_pictures(const std::filesystem::path& folder);

}  // namespace tamis::lab
