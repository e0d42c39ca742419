#include "paper/command/data_file.hpp"

namespace tamis::lab {

std::filesystem::path data_file(std::string_view name) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return (program.parent_path() / TAMIS_DATA_FROM_PROGRAM / name).lexically_normal();
}

}  // namespace tamis::lab
