// Curved motion as straight pieces that can be looked at.
#pragma once
#include <span>
#include <string>

#include "files/view/recording.hpp"
#include "tamis/path.hpp"

namespace tamis::io {

/// What was found on a path.
struct FoundOnPath {
  std::span<const Contact> contacts;  ///< all of them, or those that are to be shown
  double free_before = 1;             ///< proven: no pair meets before this time
  std::uint64_t ignored = 0;          ///< pairs that touch at the start, as Statistics::ignored
};

/// Adds so many pieces to the recording that no vertex deviates from one by more than the eye sees; but at most 64. A
/// contact is shown in the piece in which its bracket begins, at times of that piece. A recording that has frames goes
/// on where it ended. `step`: in the names of frames before "t = 0.25"; may be empty.
void add_path(Recording& recording, const Path& path, const FoundOnPath& found, const std::string& step = "");

}  // namespace tamis::io
