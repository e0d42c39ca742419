// The handle of a mesh.
#pragma once
#include <optional>

#include "c/failure.hpp"
#include "tamis/mesh.hpp"

struct tamis_mesh {
  tamis::c::Outcome outcome;
  std::optional<tamis::Mesh> mesh;  ///< none if it could not be made
};
