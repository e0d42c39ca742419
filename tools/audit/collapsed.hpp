// Objects that have collapsed: all of their vertices lie at one point, as in a frame that was never written, or their
// triangles on one line along an axis. Parts of such an object touch each other, which is one fact and not n^2 pairs.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tamis/components.hpp"
#include "tamis/positions.hpp"

namespace tamis::audit {

struct Collapsed {
  std::vector<bool> components;  ///< which components of the mesh have collapsed; empty if none has
  std::string sentence;          ///< "all vertices lie at one point"; empty if none has

  bool any() const { return !components.empty(); }
};

/// Finds the components that have collapsed; of those with fewer than ten vertices only if all of the mesh lies at one
/// point. Time: linear. REQUIRES: the mesh's components, and finite positions of its points.
Collapsed collapsed_in(const Mesh& mesh, const Components& components, const Positions& positions);

/// The mesh without these components, with the same vertices; nothing if that leaves no feature.
std::optional<Mesh> without(const Mesh& mesh, const Components& components, const std::vector<bool>& left_out);

}  // namespace tamis::audit
