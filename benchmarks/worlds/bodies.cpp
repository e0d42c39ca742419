// Balls: two large ones, and many small ones.
#include <cmath>

#include "worlds/rows.hpp"

namespace tamis::worlds {

/// Two large balls with rough surfaces, near each other. One turns.
void two_large_bodies(int steps) {
  scenes::Shape rough = scenes::unit_sphere(41);
  for (std::size_t v = 0; v < rough.points.size(); ++v)
    for (double& x : rough.points[v]) x *= 1 + 0.005 * std::sin(static_cast<double>(7 * v));
  const Shape ball = shape_of(rough);
  World world(options());
  world.add(ball, Rigid{interpolated_chain({{0, 0, 0}, {}}, {{0, 0, 0.001}, {}})});
  const BodyId turning = world.add(ball, Static{});
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        const double angle = 0.05 * step;
        world.move(turning, Rigid{interpolated_chain({{2.012, 0, 0}, {angle, 0.3, 0}},
                                                     {{1.998, 0, 0}, {angle + 0.05, 0.3, 0}})});
      },
      [&] { first = world.earliest(); });
  print_row("earliest of two rough balls of 20,172 triangles, near, one turning", first.contact.has_value(), cost);
}

/// `count` turning balls in a lattice. A tenth of them stand in pairs that come near each other.
void many_bodies(int count, int steps) {
  const Shape ball = shape_of(scenes::unit_sphere(9));
  World world(options());
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  const auto chain = [&](int body, int step) {
    const int pair = body / 20, in_pair = body % 20;
    const bool is_near = in_pair < 2;
    // Of each twenty bodies, the first two share a place of the lattice and are near each other.
    const int place = pair * 20 + (is_near ? 0 : in_pair);
    Pose start{{4.0 * (place % side), 4.0 * (place / side % side), 4.0 * (place / (side * side))}, {}};
    const double gap = 0.004, sign = in_pair == 0 ? -1 : 1;
    if (is_near) start.position[0] += sign * (1 + gap);
    start.rotation = {0.05 * step, 0.1 * (body % 30), 0};
    Pose end = start;
    end.rotation[0] += 0.05;
    if (is_near) end.position[0] -= sign * 0.003;
    return interpolated_chain(start, end);
  };
  for (int body = 0; body < count; ++body) world.add(ball, Rigid{chain(body, 0)});
  std::vector<RigidChain> chains(static_cast<std::size_t>(count));
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

/// Turning balls in rows above a ground of two triangles. Only the first two balls are near the ground.
void balls_above_a_ground(int steps) {
  constexpr double kHalfWidth = 1e4;
  const Shape ball = shape_of(scenes::unit_sphere(4));
  World world(options());
  world.add(Shape(Mesh(4, {{0, 1, 2}, {0, 2, 3}}), {{-kHalfWidth, -kHalfWidth, 0},
                                                    {kHalfWidth, -kHalfWidth, 0},
                                                    {kHalfWidth, kHalfWidth, 0},
                                                    {-kHalfWidth, kHalfWidth, 0}}),
            Static{});
  constexpr int kBalls = 400, kSide = 20;
  const auto turn = [](int body, int step) {
    const double x = 3.0 * (body % kSide) + 0.01 * step, y = 3.0 * (body / kSide), z = body < 2 ? 1.002 : 40;
    return Rigid{turned_chain({{x, y, z}, {0.1 * step, 0, 0}}, {0.1, 0, 0}, {x + 0.01, y, z - 0.003})};
  };
  for (int body = 0; body < kBalls; ++body) world.add(ball, turn(body, 0));
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        for (int body = 0; body < kBalls; ++body) world.move(body + 1, turn(body, step));
      },
      [&] { first = world.earliest(); });
  print_row("earliest of 400 turning balls above a wide ground, two near it", first.contact.has_value(), cost);
}

/// Two balls beside each other that hardly move: alone, and with a small body that flies far past them.
void safe_steps_beside_a_far_flight(int steps) {
  const Shape ball = shape_of(scenes::unit_sphere(6));
  const Shape small(Mesh(4, {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}),
                    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  World world(options());
  world.add(ball, Static{});
  world.add(ball, Rigid{turned_chain({{2.3, 0, 0}, {}}, {0, 0, 0.01}, {2.3, 0, 0})});
  BodyStep safe;
  const auto row = [&](const std::string& what) {
    const Cost cost = milliseconds(
        steps, [](int) {}, [&] { safe = world.safe_step(0.1); });
    print_row("safe_step of two balls of 432 triangles" + what, safe.pair.has_value(), cost);
  };
  row("");
  world.add(small, Rigid{turned_chain({{-500, 3, 0}, {}}, {0.1, 0, 0}, {500, 3, 0})});
  row(" that a small body flies past, 1,000 far");
}

}  // namespace tamis::worlds
