// The files in which a step can be looked at, told apart by their extensions.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "io/view/recording.hpp"

namespace tamis::io {

struct Output {
  const char* extension;
  bool holds_sequence;  ///< else one step
  void (*write)(const std::filesystem::path& path, const Recording& recording);
};

/// All of them; the first is a table.
std::span<const Output> outputs();

/// None of outputs(): it takes options, and a library that may be absent (write_picture).
inline constexpr Output kPicture{"png", false, nullptr};

/// The kind of output that a file name asks for by its extension; none if it is none of them.
const Output* find_output(std::span<const Output> choices, const std::filesystem::path& path);

/// "html, glb, ...": for sentences.
std::string extensions(std::span<const Output> choices);

}  // namespace tamis::io
