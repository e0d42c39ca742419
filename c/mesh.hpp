// The handle of a mesh.
#pragma once
#include <optional>

#include "c/failure.hpp"
#include "tamis/mesh.hpp"

struct tamis_mesh {
  tamis::c::Outcome outcome;
  std::optional<tamis::Mesh> mesh;  ///< none if it could not be made
};

namespace tamis::c {

/// Throws InvalidMesh if the mesh could not be made.
inline const Mesh& made(const tamis_mesh* mesh) {
  if (!required(mesh, "mesh").mesh)
    throw InvalidMesh("the mesh could not be made: " + std::string(mesh->outcome.message()));
  return *mesh->mesh;
}

}  // namespace tamis::c
