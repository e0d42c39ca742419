// Any bytes through the OFF reader: a usable mesh, or one printable sentence.
#include "files/mesh/off.hpp"
#include "fuzz/reader_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tamis::fuzz::check_reader(
      data, size, [](std::string_view bytes) { tamis::fuzz::check_mesh(tamis::io::parse_off(bytes, "file")); });
  return 0;
}
