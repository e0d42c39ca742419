// A step as glTF 2.0 in one binary file: the motion is one morph target, whose weight is the time.
#pragma once
#include <filesystem>
#include <span>

#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// Triangles, rods and loose points move from `start` (weight 0) to `end` (weight 1); so do the contacts' points and
/// normals, with every contact's numbers as `extras` of their node. An animation takes the weight from 0 to 1 in a
/// second. Positions are floats about the middle of the scene. REQUIRES: rows for each vertex of the mesh, finite for
/// those it uses. Atomically. Throws FileError, also if a used vertex lies too far out for floats.
void write_glb(const std::filesystem::path& path, const Mesh& mesh, std::span<const Point> start,
               std::span<const Point> end, std::span<const Contact> contacts);

}  // namespace tamis::io
