// Contacts in files to look at.
#pragma once
#include <filesystem>
#include <span>

#include "tamis/detector.hpp"

namespace tamis::python {

/// `part`: of what the detector found in the step. It is asked again, for the pairs that each stage leaves, and so that
/// a step that has changed meanwhile is refused: InvalidStep. Throws io::FileError.
void write_motion(const std::filesystem::path& to, Detector& detector, const Step& step, const QueryOptions& asked,
                  std::span<const Contact> part);
/// The same of a path, as a sequence of straight pieces, so many that no vertex deviates from one by more than the eye
/// sees; but at most 64. A contact is shown in the piece in which its bracket begins, at times of that piece. Throws
/// InvalidPath if the path has changed; Error if the file can only hold one piece.
void write_motion(const std::filesystem::path& to, Detector& detector, const Path& path, const PathOptions& asked,
                  std::span<const Contact> part);

}  // namespace tamis::python
