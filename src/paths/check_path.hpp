// What a path may be made of.
#pragma once
#include <string>

#include "tamis/error.hpp"

namespace tamis {

inline void check_path(bool ok, const std::string& message) {
  if (!ok) throw InvalidPath(message);
}

}  // namespace tamis
