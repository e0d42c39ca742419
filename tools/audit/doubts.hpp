// What is odd about positions: facts of which a user should know, as they explain answers.
#pragma once
#include <cstddef>
#include <string>

#include "tamis/mesh.hpp"
#include "tamis/positions.hpp"

namespace tamis::audit {

/// How many of the vertices that the mesh uses lie exactly where another one lies, the first of each place not counted.
std::size_t coincident_vertices(const Mesh& mesh, const Positions& positions);

/// A sentence on coincident_vertices; empty if there are none.
std::string doubt_about_coincidence(const Mesh& mesh, const Positions& positions);

/// A sentence if the mesh is some hundred times as large at one end of a step as at the other, as if the two had
/// different units; otherwise empty. A mesh that shrinks to a point raises no such doubt,
/// and points that are not finite do not count.
std::string doubt_about_units(const Positions& start, const Positions& end);

}  // namespace tamis::audit
