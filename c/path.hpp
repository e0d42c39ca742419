// The handle of a path.
#pragma once
#include <memory>

#include "c/failure.hpp"
#include "tamis/path.hpp"

struct tamis_path {
  tamis::c::Outcome outcome;
  std::unique_ptr<const tamis::Path> path;  ///< none if it could not be made
};
