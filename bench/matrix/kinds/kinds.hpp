// Scenes that only the matrix needs: same signature as scenes/generators/generators.hpp.
#pragma once
#include <cstdint>

#include "scenes/scene.hpp"

namespace tamis::matrix {

/// Two sheets that run into each other, whose grids' lines are a thousand times as far apart at the rim as in the
/// middle.
scenes::Scene graded_sheets(Index triangles, std::uint64_t seed);

// Colliding bodies or folded cloth, moved otherwise.
scenes::Scene fast_body(Index triangles, std::uint64_t seed);        ///< one body flies through the whole heap
scenes::Scene spinning_bodies(Index triangles, std::uint64_t seed);  ///< each about itself by a quarter of a turn
scenes::Scene fast_together(Index triangles, std::uint64_t seed);   ///< all a hundred times as far as the scene is wide
scenes::Scene passing_bodies(Index triangles, std::uint64_t seed);  ///< two, which change places along one line
/// Soup, of sixteen groups that are everywhere.
scenes::Scene scattered_groups(Index triangles, std::uint64_t seed);

// As simulations make them.
scenes::Scene sleeve_on_arm(Index triangles, std::uint64_t seed);  ///< two layers of cloth slide on an arm that bends
scenes::Scene shell_on_core(Index triangles, std::uint64_t seed);  ///< a shell wrinkles over a core with as many rows
scenes::Scene cloth_through_ring(Index triangles, std::uint64_t seed);    ///< pulled through it, in folds
scenes::Scene ball_through_curtain(Index triangles, std::uint64_t seed);  ///< which hardly moves
scenes::Scene chain(Index triangles, std::uint64_t seed);                 ///< its links swing
scenes::Scene rope_on_post(Index triangles, std::uint64_t seed);          ///< three strands, drawn tight around it
scenes::Scene hair(Index triangles, std::uint64_t seed);             ///< strips two vertices wide sway about a head
scenes::Scene felt(Index triangles, std::uint64_t seed);             ///< pressed fibres, of loose edges
scenes::Scene drum_of_grains(Index triangles, std::uint64_t seed);   ///< of few long triangles, it turns
scenes::Scene vehicle_in_city(Index triangles, std::uint64_t seed);  ///< all else stands

scenes::Scene polygons_in_plane(Index triangles, std::uint64_t seed);  ///< of loose edges, which run into each other

// What is far from all else.
scenes::Scene body_fallen_off(Index triangles, std::uint64_t seed);   ///< 10^4 widths below a heap of others
scenes::Scene vertex_flies_off(Index triangles, std::uint64_t seed);  ///< of a cloth, 10^5 of its widths in a step
scenes::Scene cloth_on_terrain(Index triangles, std::uint64_t seed);  ///< of 10^4 widths, and most vertices

// Bad input.
scenes::Scene huge_beside_tiny(Index triangles, std::uint64_t seed);   ///< motion of 1e300 beside 1e-300
scenes::Scene infinite_ratio(Index triangles, std::uint64_t seed);     ///< a mesh of 1e-310 that moves by 1
scenes::Scene exploding_cloth(Index triangles, std::uint64_t seed);    ///< each vertex flies off by itself
scenes::Scene one_flies_through(Index triangles, std::uint64_t seed);  ///< one vertex, through all layers of a cloth

}  // namespace tamis::matrix
