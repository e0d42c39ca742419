// What was simulated as OBJ files, one a step, which `tamis view` shows.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "adapters/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// FOLDER/NAME_0000.obj, ...: of each time, all points, with the same faces. Makes the folder. Throws
/// std::runtime_error where a file cannot be written.
void write_frames(const std::filesystem::path& folder, const std::string& name,
                  std::span<const std::vector<Point>> frames, std::span<const Face> faces);
/// The same of bodies: those of `first` and after.
void write_frames(const std::filesystem::path& folder, const std::string& name, std::span<const Triangles> bodies,
                  const Places& places, std::size_t first = 0);

}  // namespace tamis::bullet
