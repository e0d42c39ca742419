// Scenes that only the matrix needs, with the signature of those in tools/scenes/generators/generators.hpp.
#pragma once
#include <cstdint>

#include "scenes/scene.hpp"

namespace tamis::matrix {

/// Two sheets that run into each other. The lines of their grids are a thousand times as far apart at the rim as in the
/// middle.
scenes::Scene graded_sheets(Index triangles, std::uint64_t seed);

// Colliding bodies or folded cloth, with other motions.
scenes::Scene fast_body(Index triangles, std::uint64_t seed);        ///< one body flies through the whole heap
scenes::Scene spinning_bodies(Index triangles, std::uint64_t seed);  ///< each about itself by a quarter of a turn
scenes::Scene fast_together(Index triangles, std::uint64_t seed);   ///< all a hundred times as far as the scene is wide
scenes::Scene passing_bodies(Index triangles, std::uint64_t seed);  ///< two, which change places along one line
/// Soup whose triangles belong to sixteen groups, each spread over the whole scene.
scenes::Scene scattered_groups(Index triangles, std::uint64_t seed);

// Scenes as simulations make them.
scenes::Scene sleeve_on_arm(Index triangles, std::uint64_t seed);  ///< two layers of cloth slide on an arm that bends
scenes::Scene shell_on_core(Index triangles, std::uint64_t seed);  ///< a shell wrinkles over a core with as many rows
scenes::Scene cloth_through_ring(Index triangles, std::uint64_t seed);    ///< the cloth is pulled through, in folds
scenes::Scene ball_through_curtain(Index triangles, std::uint64_t seed);  ///< the curtain hardly moves
scenes::Scene chain(Index triangles, std::uint64_t seed);                 ///< its links swing
scenes::Scene rope_on_post(Index triangles, std::uint64_t seed);          ///< three strands, drawn tight around a post
scenes::Scene hair(Index triangles, std::uint64_t seed);             ///< strips two vertices wide sway about a head
scenes::Scene felt(Index triangles, std::uint64_t seed);             ///< pressed fibres, of loose edges
scenes::Scene drum_of_grains(Index triangles, std::uint64_t seed);   ///< the drum, of few long triangles, turns
scenes::Scene vehicle_in_city(Index triangles, std::uint64_t seed);  ///< only the vehicle moves

scenes::Scene polygons_in_plane(Index triangles, std::uint64_t seed);  ///< of loose edges, which run into each other

// Scenes with outliers.
scenes::Scene body_fallen_off(Index triangles, std::uint64_t seed);   ///< 10^4 widths below a heap of others
scenes::Scene vertex_flies_off(Index triangles, std::uint64_t seed);  ///< one vertex of a cloth, by 10^5 of its widths
scenes::Scene cloth_on_terrain(Index triangles, std::uint64_t seed);  ///< terrain of 10^4 widths and most vertices

// Bad input.
scenes::Scene huge_beside_tiny(Index triangles, std::uint64_t seed);   ///< motion of 1e300 beside 1e-300
scenes::Scene infinite_ratio(Index triangles, std::uint64_t seed);     ///< a mesh of 1e-310 that moves by 1
scenes::Scene exploding_cloth(Index triangles, std::uint64_t seed);    ///< each vertex flies off in its own direction
scenes::Scene one_flies_through(Index triangles, std::uint64_t seed);  ///< one vertex, through all layers of a cloth

}  // namespace tamis::matrix
