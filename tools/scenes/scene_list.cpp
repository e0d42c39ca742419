#include "scenes/scene_list.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "scenes/generators/generators.hpp"
#include "tamis/error.hpp"

namespace tamis::scenes {
namespace {

constexpr std::array kRecipes{
    Recipe{"folded-cloth", "one sheet in many layers that press on each other", true, folded_cloth},
    Recipe{"colliding-bodies", "a heap of closed, bumpy spheres that run into each other", true, colliding_bodies},
    Recipe{"twisted-rods", "four round rods twisted around each other by half a turn, pressed together", false,
           twisted_rods},
    Recipe{"stacked-boxes", "boxes in brickwork that share planes, and rest, slide, lift off or press down", false,
           stacked_boxes},
    Recipe{"soup", "separate triangles that move at random", true, soup},
    Recipe{"tangle", "random triangles over few vertices: non-manifold, and most pairs touch", false, tangle},
    Recipe{"fans", "edges with many triangles, and vertices where fans meet, moving through each other", false, fans},
    Recipe{"degenerate", "zero areas, repeated indices, zero lengths, duplicates, on a coarse lattice", false,
           degenerate},
    Recipe{"touching-spheres", "mirrored spheres with dyadic coordinates, touching exactly on symmetry planes", false,
           touching_spheres},
    Recipe{"mirrored", "triangles on a lattice with their mirror images: every contact lies on the mirror", false,
           mirrored},
    Recipe{"reduced-sheet", "a sheet bent into a U that moves in a subspace of nine modes", true, reduced_sheet_scene},
    Recipe{"rod", "a chain of loose edges between triangles", false, rod},
    Recipe{"points-on-cloth", "loose points falling on a sheet, some exactly on its vertices and edges", false,
           points_on_cloth},
    Recipe{"sliding-sheets", "sheets that slide within one moving plane: always coplanar", false, sliding_sheets},
    Recipe{"static", "intersecting and touching meshes that do not move", false, static_meshes},
};

}  // namespace

std::span<const Recipe> recipes() { return kRecipes; }

Scene scene_by_name(std::string_view name, Index triangles, std::uint64_t seed) {
  const auto recipe = std::find_if(kRecipes.begin(), kRecipes.end(), [&](const Recipe& r) { return r.name == name; });
  if (recipe == kRecipes.end()) {
    std::string names;
    for (const Recipe& r : kRecipes) names += (names.empty() ? "" : ", ") + std::string(r.name);
    throw InvalidOptions("there is no scene '" + std::string(name) + "': choose one of " + names);
  }
  if (triangles < 1)
    throw InvalidOptions("a scene of " + std::to_string(triangles) + " triangles cannot be made: give at least 1");
  Scene scene = recipe->make(triangles, seed);
  scene.name = name;
  return scene;
}

}  // namespace tamis::scenes
