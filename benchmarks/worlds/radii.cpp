// Many thick bodies, each near others.
#include <cmath>

#include "worlds/rows.hpp"

namespace tamis::worlds {

namespace {

/// A row of cubes that shake. The gap between neighbours is little more than the sum of their radii.
void thick_cubes(const std::string& what, int count, int steps, const std::function<double(int)>& radius) {
  constexpr double kGap = 0.02;
  const Shape cube = shape_of(scenes::unit_cube(1));
  const auto way = [](int body, int step) {
    const auto place = [body](int at) {
      return Pose{{(2 + kGap) * body, 0.2 * kGap * std::sin(body + 0.5 * at), 0}, {}};
    };
    return Rigid{interpolated_chain(place(step), place(step + 1))};
  };
  World world(options());
  for (int body = 0; body < count; ++body) world.set_radius(world.add(cube, way(body, 0)), kGap * radius(body));
  std::size_t found = 0;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        for (int body = 0; body < count; ++body) world.move(body, way(body, step));
      },
      [&] { found = world.contacts().size(); });
  print_row("contacts of a row of " + std::to_string(count) + " thick cubes, " + what, found, cost);
}

}  // namespace

void many_radii(int count, int steps) {
  thick_cubes("of one radius", count, steps, [](int) { return 0.49; });
  thick_cubes("of as many radii", count, steps, [count](int body) { return 0.49 - 0.01 * body / count; });
}

}  // namespace tamis::worlds
