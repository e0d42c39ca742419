// Writes simulated motions as PLY files, one a step, which `tamis view` shows.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "integrations/bullet/throws/arena.hpp"

namespace tamis::bullet {

/// Writes FOLDER/NAME_0000.ply, ...: for each time all points, with the same faces. Makes the folder. Throws
/// io::FileError if a file cannot be written, std::filesystem::filesystem_error if the folder cannot be made.
void write_frames(const std::filesystem::path& folder, const std::string& name,
                  std::span<const std::vector<Point>> frames, std::span<const Face> faces);
/// The same for the bodies from number `first` on.
void write_frames(const std::filesystem::path& folder, const std::string& name, std::span<const Triangles> bodies,
                  const Places& places, std::size_t first = 0);

}  // namespace tamis::bullet
