// Files that are installed with the command.
#pragma once
#include <filesystem>
#include <string_view>

namespace tamis::lab {

/// The path of the file, found from the running program, wherever that was installed or copied to. (A build tree has a
/// copy.) The file may be missing.
std::filesystem::path data_file(std::string_view name);

}  // namespace tamis::lab
