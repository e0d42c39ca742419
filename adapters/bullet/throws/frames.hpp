// What was simulated as PLY files, one a step, which `tamis view` shows.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "adapters/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// FOLDER/NAME_0000.ply, ...: of each time, all points, with the same faces. Makes the folder. Throws io::FileError
/// where a file cannot be written, std::filesystem::filesystem_error where the folder cannot be made.
void write_frames(const std::filesystem::path& folder, const std::string& name,
                  std::span<const std::vector<Point>> frames, std::span<const Face> faces);
/// The same of bodies: those of `first` and after.
void write_frames(const std::filesystem::path& folder, const std::string& name, std::span<const Triangles> bodies,
                  const Places& places, std::size_t first = 0);

}  // namespace tamis::bullet
