// The files in which a step, or a pose, can be looked at, told apart by their extensions.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "files/format.hpp"
#include "files/view/recording.hpp"

namespace tamis::io {

struct Output {
  const char* extension;
  bool holds_pose;
  bool holds_sequence;  ///< else one step
  void (*write)(const std::filesystem::path& path, const Recording& recording);
};

/// All of them; the first is a table.
std::span<const Output> outputs();

/// The output that a file name asks for by its extension (format_of). Throws FileError.
const Output& output_for(const std::filesystem::path& path, std::span<const Output> choices,
                         NoExtension without = NoExtension::is_first_format);

/// "html, glb, ...": for the help.
std::string extensions(std::span<const Output> choices);

}  // namespace tamis::io
