// Plates that turn on a plane.
#include <array>
#include <cstdio>

#include "tamis/rigid_path.hpp"
#include "worlds/rows.hpp"

namespace tamis::worlds {

namespace {

std::vector<Point> scaled(std::vector<Point> points, double by) {
  for (Point& p : points)
    for (double& x : p) x *= by;
  return points;
}

/// The direction `in_body` of a body with this rotation vector, in world coordinates.
Point direction_of(const Point& rotation, const Point& in_body) {
  const RigidPath path({in_body}, {0}, {{{{{0, 0, 0}, rotation}, {{0, 0, 0}, rotation}}}});
  Point direction{};
  double error = 0;
  path.points_at(0, std::array<Index, 1>{0}, {&direction, 1}, {&error, 1});
  return direction;
}

/// A plate that turns on another one, in an oblique plane. They are apart by `gap`, up to rounding.
void plate_on_plate(double gap, int steps) {
  const scenes::Shape plate = sheet(16, 0.125, [](double, double) { return 0.0; });
  const Point askew{0.3, 0.2, 0.5};
  World world(options());
  world.add(shape_of(plate), Static{{{0, 0, 0}, askew}});
  const BodyId turning = world.add(shape_of({scaled(plate.points, 0.7), plate.faces}), Static{});
  const Point normal = direction_of(askew, {0, 0, 1});
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        const Pose pose{scaled({normal}, gap)[0], askew};
        world.move(turning, Rigid{turned_chain(pose, scaled({normal}, 0.3 + 0.01 * step)[0], pose.position)});
      },
      [&] { first = world.earliest(); });
  char text[120];
  std::snprintf(text, sizeof text, "earliest of a plate of 512 triangles that turns on another one, %g apart", gap);
  print_row(text, first.contact.has_value(), cost);
}

}  // namespace

void plates(int steps) {
  for (const double gap : {1e-6, 1e-10, 1e-13}) plate_on_plate(gap, steps);
}

}  // namespace tamis::worlds
