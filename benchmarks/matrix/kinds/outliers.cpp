#include "scenes/outliers.hpp"

#include "matrix/kinds/kinds.hpp"
#include "scenes/generators/generators.hpp"

namespace tamis::matrix {

using namespace scenes;

Scene body_fallen_off(Index triangles, std::uint64_t seed) {
  Scene scene = colliding_bodies(triangles, seed);
  add_outliers(scene, Outliers::fallen_triangles, 1e4);
  return scene;
}

Scene vertex_flies_off(Index triangles, std::uint64_t seed) {
  Scene scene = folded_cloth(triangles, seed);
  add_outliers(scene, Outliers::flying_vertex, 1e5);
  return scene;
}

Scene cloth_on_terrain(Index triangles, std::uint64_t seed) {
  Scene scene = folded_cloth(triangles / 3, seed);
  add_outliers(scene, Outliers::wide_terrain, 1e4);
  return scene;
}

}  // namespace tamis::matrix
