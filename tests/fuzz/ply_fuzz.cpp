// Any bytes through the PLY reader: a usable mesh, or one printable sentence.
#include "files/mesh/ply.hpp"
#include "fuzz/reader_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tamis::fuzz::check_reader(
      data, size, [](std::string_view bytes) { tamis::fuzz::check_mesh(tamis::io::parse_ply(bytes, "file")); });
  return 0;
}
