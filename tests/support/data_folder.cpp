#include "support/data_folder.hpp"

#include <cstdlib>

namespace tamis::test {

namespace fs = std::filesystem;

fs::path data_folder() {
  const char* set = std::getenv("TAMIS_DATA");
  const fs::path folder = set != nullptr ? fs::path(set) : fs::path(TAMIS_DEFAULT_DATA);
  return fs::is_directory(folder / "queries") ? folder : fs::path();
}

}  // namespace tamis::test
