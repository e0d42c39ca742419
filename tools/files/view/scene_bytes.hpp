// A recording as the bytes that the viewer reads; tools/viewer/src/scene_file.ts is the other side.
#pragma once
#include <string>

#include "files/view/recording.hpp"

namespace tamis::io {

/// The length of a JSON header (32 bits, least significant byte first), the header, then the columns that it lists.
std::string scene_bytes(const Recording& recording);

}  // namespace tamis::io
