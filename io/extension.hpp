// What a file's name ends in.
#pragma once
#include <cctype>
#include <filesystem>
#include <string>

namespace tamis::io {

/// Of the name, from its last dot on, in small letters: ".ply"; empty if it has none.
inline std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace tamis::io
