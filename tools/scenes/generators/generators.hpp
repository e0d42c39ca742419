// The functions that make the scenes of scene_list.hpp, one a file. The same size and seed give the same bits
// everywhere.
#pragma once
#include <cstdint>

#include "scenes/scene.hpp"

namespace tamis::scenes {

Scene colliding_bodies(Index triangles, std::uint64_t seed);
Scene degenerate(Index triangles, std::uint64_t seed);
Scene fans(Index triangles, std::uint64_t seed);
Scene folded_cloth(Index triangles, std::uint64_t seed);
Scene mirrored(Index triangles, std::uint64_t seed);
Scene points_on_cloth(Index triangles, std::uint64_t seed);
Scene reduced_sheet_scene(Index triangles, std::uint64_t seed);  ///< see tools/scenes/reduced_scene.hpp
Scene rod(Index triangles, std::uint64_t seed);
Scene sliding_sheets(Index triangles, std::uint64_t seed);
Scene soup(Index triangles, std::uint64_t seed);
Scene stacked_boxes(Index triangles, std::uint64_t seed);
Scene static_meshes(Index triangles, std::uint64_t seed);
Scene tangle(Index triangles, std::uint64_t seed);
Scene touching_spheres(Index triangles, std::uint64_t seed);
Scene twisted_rods(Index triangles, std::uint64_t seed);

}  // namespace tamis::scenes
