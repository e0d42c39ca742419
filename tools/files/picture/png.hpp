// Pixels as a PNG file.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace tamis::io {

/// Row by row from the top, each pixel red, green and blue as they stand on a screen.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;
};

/// Atomically. Throws FileError.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace tamis::io
