// Contacts in files to look at.
#pragma once
#include <filesystem>
#include <optional>
#include <span>

#include "tamis/detector.hpp"

namespace tamis::python {

/// `part`: of what the detector found in the step. It is asked again, for the pairs that each stage leaves, and so that
/// a step that has changed meanwhile is refused: InvalidStep. Throws io::FileError.
void write_step(const std::filesystem::path& path, Detector& detector, const Step& step,
                std::optional<double> min_separation, std::span<const Contact> part);

}  // namespace tamis::python
