// The extension of a file's name.
#pragma once
#include <cctype>
#include <filesystem>
#include <string>

namespace tamis::io {

/// The extension with its dot, in small letters: ".ply"; empty if the name has none.
inline std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace tamis::io
