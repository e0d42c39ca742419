// A detector that finds contacts as the library does, or by deciding every pair: tests compare the two.
#pragma once
#include <cstdint>
#include <string_view>

#include "tamis/detector.hpp"

namespace tamis::yardstick {

enum class Method : std::uint8_t {
  tamis,  ///< the library
  brute,  ///< every pair, no hierarchy
};

std::string_view name_of(Method);

/// The library's options and the method. Does not convert to tamis::Options: a Detector made from those would silently
/// use the method `tamis`.
class Options : private tamis::Options {
 public:
  Options() = default;
  Options(tamis::Options given) : tamis::Options(std::move(given)) {}  // NOLINT(google-explicit-constructor)

  using tamis::Options::filter;
  using tamis::Options::is_cancelled;
  using tamis::Options::isa;
  using tamis::Options::min_separation;
  using tamis::Options::radii;
  using tamis::Options::threads;
  Method method = Method::tamis;

  const tamis::Options& of_library() const { return *this; }
};

/// Validates and sorts as every Detector does. Throws InvalidOptions as Detector does.
Detector make_detector(Mesh mesh, const Options& options);

}  // namespace tamis::yardstick
