// A step as a picture: the mesh at a time, with all contacts of the step in the colours of their times. Or a pose, with
// its intersections.
#pragma once
#include <filesystem>

#include "files/view/recording.hpp"

namespace tamis::io {

struct PictureOptions {
  double time = 0;           ///< of the step, in [0,1]
  Point from{0.5, 0.45, 1};  ///< where one looks from, seen from the middle; y is up. Only the direction matters
  int width = 1280;          ///< in pixels, >= 1
  int height = 720;          ///< the same
};

/// Throws InvalidOptions, which says what to do, if this program was built without the library that draws.
void require_pictures();

/// PNG. Shows the first step, or the pose. Contacts stand where their first features are at that time; those behind a
/// surface shine through. The same bytes for any number of threads. Atomically. Throws FileError, and what
/// require_pictures throws. REQUIRES: a direction that is finite and not zero.
void write_picture(const std::filesystem::path& path, const Recording& recording, const PictureOptions& options);

}  // namespace tamis::io
