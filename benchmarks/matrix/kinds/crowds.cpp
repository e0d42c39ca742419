// Many rigid bodies, of which most move a little, or only one.
#include "matrix/kinds/forms.hpp"
#include "matrix/kinds/kinds.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::matrix {

using namespace scenes;

Scene drum_of_grains(Index triangles, std::uint64_t seed) {
  const Shape grain = unit_sphere(2);
  const Index grains = std::max(Index{4}, triangles / static_cast<Index>(grain.faces.size()));
  const Index side = static_cast<Index>(std::ceil(cube_root(2.5 * grains)));
  const double cell = 2.0 / side;
  Random random(seed);
  Scene scene;
  for (Index i = 0, made = 0; i < side * side * side && made < grains; ++i) {
    const auto along = [&](Index k) { return cell * (k + 0.5) - 1; };
    const Point c{along(i % side), along(i / (side * side)), along(i / side % side)};
    if (c[0] * c[0] + c[1] * c[1] > 0.8) continue;
    const Point turned = random.point_between(-1, 1), turn = turned + random.point_between(-0.05, 0.05);
    const Point fall = (0.1 * cell) * random.point_between(-1, 1) + Point{-0.02 * c[1], 0.02 * c[0] - 0.03, 0};
    add_shape(
        scene, grain, made++, [&](const Point& p) { return c + (0.48 * cell) * rotated(p, turned); },
        [&](const Point& p) { return c + fall + (0.48 * cell) * rotated(p, turn); });
  }
  const auto wall = [](double u, double v) { return 1.05 * on_circle(v) + Point{0, 0, 2.4 * u - 1.2}; };
  add_surface(scene, {2, 48, false, true}, grains, wall, [&](double u, double v) {
    return rotated(wall(u, v), {0, 0, 0.01});
  });
  return scene;
}

Scene vehicle_in_city(Index triangles, std::uint64_t seed) {
  const Shape house = unit_cube(1);
  const Index side = side_for(triangles / 12);
  const Index houses = side * side;
  Random random(seed);
  Scene scene;
  for (Index i = 0; i < houses; ++i) {
    const double height = random.between(0.3, 3);
    const auto at = [&](const Point& p) {
      return Point{i % side + 0.35 * p[0], i / side + 0.35 * p[1], height * (p[2] + 1)};
    };
    add_shape(scene, house, i, at, at);
  }
  const auto ground = [&](double u, double v) { return Point{side * (1.2 * u - 0.1), side * (1.2 * v - 0.1), -0.001}; };
  add_surface(scene, {2, 2}, houses, ground, ground);
  const double street = side / 2 + 0.5;
  const auto vehicle = [&](const Point& p, double gone) {
    return Point{street + 0.12 * p[0], street + gone + 0.13 * p[1], 0.1 + 0.09 * p[2]};
  };
  add_shape(
      scene, unit_sphere(sphere_cells(triangles / 2, 1, triangles)), houses + 1,
      [&](const Point& p) { return vehicle(p, 0); }, [&](const Point& p) { return vehicle(p, 0.6); });
  return scene;
}

Scene polygons_in_plane(Index triangles, std::uint64_t seed) {
  constexpr Index kCorners = 16;
  const Index side = side_for(triangles / 16);
  Random random(seed);
  Scene scene;
  for (Index polygon = 0; polygon < side * side; ++polygon) {
    const Point centre{static_cast<double>(polygon % side), static_cast<double>(polygon / side), 0};
    const Point way{random.between(-0.3, 0.3), random.between(-0.3, 0.3), 0};
    const Index first = scene.vertex_count();
    for (Index k = 0; k < kCorners; ++k) {
      const Point corner = centre + random.between(0.42, 0.46) * on_circle(static_cast<double>(k) / kCorners);
      scene.add_vertex(corner, corner + way, polygon);
      scene.loose_edges.push_back({first + k, first + (k + 1) % kCorners});
    }
  }
  return scene;
}

}  // namespace tamis::matrix
