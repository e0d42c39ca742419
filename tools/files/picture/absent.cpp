// Takes the place of picture.cpp in a build without Embree or libpng.
#include "files/picture/picture.hpp"
#include "tamis/error.hpp"

namespace tamis::io {

void require_pictures() {
  throw InvalidOptions(
      "this program was built without Embree and libpng, which draw pictures: install them (Debian: libembree-dev "
      "libpng-dev) and build again, or write html");
}

void write_picture(const std::filesystem::path&, const Recording&, const PictureOptions&) { require_pictures(); }

}  // namespace tamis::io
