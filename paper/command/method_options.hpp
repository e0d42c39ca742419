// Options of the verbs that take a method.
#pragma once
#include <string>

#include "paper/options.hpp"

namespace tamis::lab {

inline constexpr const char* kDefaultBoundingVolume = "16-dop";
inline constexpr const char* kMethodHelp =
    "tamis (the library), paper (the published pipeline; default), brute (every pair; slow), or a competitor of the "
    "paper: paper-sat, paper-pfs, ...";
inline constexpr const char* kBoundingVolumeHelp =
    "of the paper's hierarchy and its competitors': sphere, aabb, obb, 16-dop (default), 18-dop or 26-dop; other "
    "methods have their own";

/// The options `given`, with a method and a bounding volume by name. Throws InvalidOptions.
inline Options options_of(const tamis::Options& given, const std::string& method, const std::string& bounding_volume) {
  Options options(given);
  choose_method(options, method);
  options.paper.bounding_volume = bounding_volume_from_name(bounding_volume);
  return options;
}

}  // namespace tamis::lab
