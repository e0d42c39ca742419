// Machines whose parts are near each other all the time.
#include "scenes/machines.hpp"

#include "worlds/rows.hpp"

namespace tamis::worlds {

namespace {

/// Asks about the step of a machine and the way back, in turn.
void machine_row(const std::string& what, const scenes::Machine& machine, int steps) {
  World world(options());
  std::vector<Shape> shapes;
  for (const scenes::Shape& shape : machine.shapes) shapes.push_back(shape_of(shape));
  std::size_t triangles = 0;
  for (const auto& [shape, way] : machine.parts) {
    world.add(shapes[shape], Static{way.start});
    triangles += machine.shapes[shape].faces.size();
  }
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        for (std::size_t i = 0; i < machine.parts.size(); ++i) {
          const auto& [start, end] = machine.parts[i].way;
          if (start.position == end.position && start.rotation == end.rotation) continue;
          world.move(static_cast<BodyId>(i),
                     Rigid{step % 2 == 0 ? interpolated_chain(start, end) : interpolated_chain(end, start)});
        }
      },
      [&] { first = world.earliest(); });
  print_row("earliest of " + what + ", " + std::to_string(triangles) + " triangles", first.contact.has_value(), cost);
}

}  // namespace

void machines(const std::string& which, int steps) {
  machine_row("a nut that turns by 0.1 radians on a bolt", scenes::nut_on_bolt(32, 0.1, false), steps);
  machine_row("a nut that turns by 1 radian on a bolt", scenes::nut_on_bolt(32, 1, false), steps);
  if (which == "nut") return;
  machine_row("12 gears of 24 teeth that turn by 0.1 radians", scenes::gear_train(12, 24, 0.1, false), steps);
  machine_row("a net of 280 linked rings that sag", scenes::chain_net(10, 16, 8, 0.02), steps);
  machine_row("a block that flies through a narrow tunnel", scenes::tunnel(16, 0.005), steps);
}

}  // namespace tamis::worlds
