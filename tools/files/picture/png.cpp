#include "files/picture/png.hpp"

#include <png.h>

#include <new>
#include <string>

#include "files/atomic_file.hpp"

namespace tamis::io {

void write_png(const std::filesystem::path& path, const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  // Fails only for want of memory: the room is enough for any picture.
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr)) throw std::bad_alloc();
  bytes.resize(size);
  AtomicFile file(path);
  file.append(bytes);
  file.commit();
}

}  // namespace tamis::io
