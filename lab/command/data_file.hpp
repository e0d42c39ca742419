// Files that are installed with the command.
#pragma once
#include <filesystem>
#include <string_view>

namespace tamis::lab {

/// Where the file stands: beside the running program, wherever it was installed or copied to; in a build tree there is
/// a copy. It may be missing.
std::filesystem::path data_file(std::string_view name);

}  // namespace tamis::lab
