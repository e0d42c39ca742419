// Cloth and shells, as simulations move them.
#include "matrix/kinds/forms.hpp"
#include "matrix/kinds/kinds.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace tamis::matrix {

using namespace scenes;

Scene sleeve_on_arm(Index triangles, std::uint64_t seed) {
  constexpr Index kLayers = 3;
  const SmoothNoise noise(seed);
  const Index around = side_for(triangles / 5), along = rows_for(triangles / kLayers, around);
  const auto at = [&](Index layer, double u, double v, double slide, double bend) {
    const Point rim = on_circle(v);
    const double z = 2 * u - 1 + slide * layer;
    const double wrinkle = layer == 0 ? 0 : 0.015 * std::fabs(noise(3 * rim[0], 3 * rim[1], 12 * z));
    const double radius = 0.2 * (1 + 0.02 * layer) + wrinkle;
    return rotated({radius * rim[0], radius * rim[1], z}, {0, bend * ramp(z, -0.2, 0.2), 0});
  };
  Scene scene;
  for (Index layer = 0; layer < kLayers; ++layer)
    add_surface(
        scene, {along, around, false, true}, layer, [&](double u, double v) { return at(layer, u, v, 0, 0.1); },
        [&](double u, double v) { return at(layer, u, v, -0.005, 0.14); });
  return scene;
}

Scene shell_on_core(Index triangles, std::uint64_t seed) {
  const SmoothNoise noise(seed);
  const Index side = side_for(triangles / 2);
  const auto shell = [&](double u, double v, double depth, double length) {
    const Point rim = on_circle(v);
    const double r = 1 + depth * (wave(20 * u) * wave(6 * v) + 0.3 * noise(9 * u, 5 * rim[0], 5 * rim[1]));
    return Point{r * rim[0], r * rim[1], length * u};
  };
  const auto core = [](double u, double v) { return 0.93 * on_circle(v) + Point{0, 0, 2 * u}; };
  Scene scene;
  add_surface(
      scene, {side, side, false, true}, 0, [&](double u, double v) { return shell(u, v, 0.04, 1.6); },
      [&](double u, double v) { return shell(u, v, 0.055, 1.56); });
  add_surface(scene, {side, side, false, true}, 1, core, core);
  return scene;
}

Scene cloth_through_ring(Index triangles, std::uint64_t seed) {
  const SmoothNoise noise(seed);
  const Index side = side_for(triangles * 4 / 5), around = side_for(triangles / 20);
  const auto cloth = [&](double u, double v, double pulled) {
    const Point rim = on_circle(v);
    const double z = 2 * u - 1 + pulled, along = std::fabs(z) + 0.1;
    const double radius = (0.15 + 0.5 * along * along * u) * (1 + 0.25 * wave(14 * v) * ramp(1 - along, 0, 1));
    return Point{radius * rim[0], radius * rim[1], z + 0.02 * noise(6 * u, 9 * rim[0], 9 * rim[1])};
  };
  const auto ring = [](double u) { return 0.33 * on_circle(u); };
  Scene scene;
  add_surface(
      scene, {side, side, false, true}, 0, [&](double u, double v) { return cloth(u, v, 0); },
      [&](double u, double v) { return cloth(u, v, 0.03); });
  add_tube(scene, {2 * around, around, true, true}, 0.1, 1, ring, ring);
  return scene;
}

Scene ball_through_curtain(Index triangles, std::uint64_t seed) {
  const SmoothNoise noise(seed);
  const Index side = side_for(triangles * 2 / 3);
  const auto curtain = [&](double u, double v, double sway) {
    const double fold = 0.1 * wave(8 * v) + 0.05 * noise(6 * v, 3 * u);
    return Point{2 * v - 1, fold + sway * u * noise(3 * v, 2 * u, 4), 1 - 2 * u};
  };
  Scene scene;
  add_surface(
      scene, {side, side}, 0, [&](double u, double v) { return curtain(u, v, 0); },
      [&](double u, double v) { return curtain(u, v, 0.02); });
  add_shape(
      scene, unit_sphere(sphere_cells(triangles / 3, 1, triangles)), 1,
      [](const Point& p) {
        return 0.2 * p + Point{0.1, -0.4, 0};
      },
      [](const Point& p) {
        return 0.2 * rotated(p, {0, 0, 0.05}) + Point{0.12, 0.2, 0.02};
      });
  return scene;
}

}  // namespace tamis::matrix
