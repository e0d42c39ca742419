// The files in which a step can be looked at, told apart by their extensions.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "cli/view/recording.hpp"

namespace tamis::cli {

struct Output {
  const char* extension;
  bool holds_sequence;  ///< else one step
  void (*write)(const std::filesystem::path& path, const Recording& recording);
};

/// The kind of output that a file name asks for by its extension; none if it is none of them.
const Output* find_output(const std::filesystem::path& path);

/// The same. Throws InvalidOptions, naming the choices, if it is none of them, or
/// if there are more steps than it holds.
const Output& output_for(const std::filesystem::path& path, std::size_t steps);

/// "html, glb, ...": for the help of an option.
std::string output_extensions();

}  // namespace tamis::cli
