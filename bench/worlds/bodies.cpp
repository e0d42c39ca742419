// Balls: two large ones, and many small ones.
#include <cmath>

#include "worlds/rows.hpp"

namespace tamis::worlds {

/// Two large balls whose surfaces are rough, near each other, one turning.
void two_large_bodies(int steps) {
  scenes::Shape rough = scenes::unit_sphere(41);
  for (std::size_t v = 0; v < rough.points.size(); ++v)
    for (double& x : rough.points[v]) x *= 1 + 0.005 * std::sin(static_cast<double>(7 * v));
  const Shape ball = shape_of(rough);
  World world(options());
  world.add(ball, Rigid{interpolated({{0, 0, 0}, {}}, {{0, 0, 0.001}, {}})});
  const BodyId turning = world.add(ball, Static{});
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        const double angle = 0.05 * step;
        world.move(turning,
                   Rigid{interpolated({{2.012, 0, 0}, {angle, 0.3, 0}}, {{1.998, 0, 0}, {angle + 0.05, 0.3, 0}})});
      },
      [&] { first = world.earliest(); });
  print_row("earliest of two rough balls of 20,172 triangles, near, one turning", first.contact.has_value(), cost);
}

/// `count` balls in a lattice, of which each tenth has another one beside it that comes near while both turn.
void many_bodies(int count, int steps) {
  const Shape ball = shape_of(scenes::unit_sphere(9));
  World world(options());
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  const auto chain = [&](int body, int step) {
    const int pair = body / 20, in_pair = body % 20;
    const bool is_near = in_pair < 2;
    // Twenty bodies a place of the lattice's rows, the first two of them near each other.
    const int place = pair * 20 + (is_near ? 0 : in_pair);
    Pose start{{4.0 * (place % side), 4.0 * (place / side % side), 4.0 * (place / (side * side))}, {}};
    const double gap = 0.004, sign = in_pair == 0 ? -1 : 1;
    if (is_near) start.position[0] += sign * (1 + gap);
    start.rotation = {0.05 * step, 0.1 * (body % 30), 0};
    Pose end = start;
    end.rotation[0] += 0.05;
    if (is_near) end.position[0] -= sign * 0.003;
    return interpolated(start, end);
  };
  for (int body = 0; body < count; ++body) world.add(ball, Rigid{chain(body, 0)});
  std::vector<Chain> chains(static_cast<std::size_t>(count));
  const auto move_all = [&] {
    for (int body = 0; body < count; ++body) world.move(body, Rigid{chains[static_cast<std::size_t>(body)]});
  };
  const auto step_to = [&](int step) {
    for (int body = 0; body < count; ++body) chains[static_cast<std::size_t>(body)] = chain(body, step);
  };
  const std::string balls = std::to_string(count) + " turning balls of 972 triangles";
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        step_to(step);
        move_all();
      },
      [&] { first = world.earliest(); });
  print_row("earliest of " + balls + ", a tenth near another", first.contact.has_value(), cost);
  print_row("move of " + balls, static_cast<std::size_t>(count), milliseconds(steps, step_to, move_all));
}

}  // namespace tamis::worlds
