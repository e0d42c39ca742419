// A detector that finds contacts as the library does, or by deciding every pair: tests compare the two.
#pragma once
#include <cstdint>
#include <string_view>

#include "support/yardstick/library_options.hpp"
#include "tamis/detector.hpp"

namespace tamis::yardstick {

enum class Method : std::uint8_t {
  tamis,  ///< the library
  brute,  ///< every pair, no hierarchy
};

std::string_view name_of(Method);

/// The library's options and the method.
struct Options : LibraryOptions {
  using LibraryOptions::LibraryOptions;
  Method method = Method::tamis;
};

/// Validates and sorts as every Detector does. Throws InvalidOptions as Detector does.
Detector make_detector(Mesh mesh, const Options& options);

}  // namespace tamis::yardstick
