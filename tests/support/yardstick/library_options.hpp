// The library's options, for a detector of another method.
#pragma once
#include <utility>

#include "tamis/options.hpp"

namespace tamis::yardstick {

/// Does not convert to tamis::Options: a Detector made from those would silently use the library's own method.
class LibraryOptions : private tamis::Options {
 public:
  LibraryOptions() = default;
  LibraryOptions(tamis::Options given) : tamis::Options(std::move(given)) {}  // NOLINT(google-explicit-constructor)

  using tamis::Options::filter;
  using tamis::Options::is_cancelled;
  using tamis::Options::isa;  ///< other methods find contacts in baseline, whatever it says
  using tamis::Options::min_separation;
  using tamis::Options::radii;
  using tamis::Options::threads;

  const tamis::Options& of_library() const { return *this; }
};

}  // namespace tamis::yardstick
