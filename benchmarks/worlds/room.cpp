// A cloth in a large room, and by itself.
#include <cmath>
#include <cstdio>

#include "tamis/detector.hpp"
#include "worlds/rows.hpp"

namespace tamis::worlds {

namespace {

std::vector<Point> moved(std::vector<Point> points, const Point& by) {
  for (Point& p : points)
    for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return points;
}

/// A wavy cloth just above the floor of a large room. It slides, and sinks a little in each step: parts of it touch.
struct Cloth {
  static constexpr double kEdge = 0.01;
  scenes::Shape shape = sheet(100, kEdge, [](double x, double y) {
    return floor_height(x, y) + kEdge * (0.3 + 0.22 * std::sin(40 * x) * std::sin(30 * y));
  });

  std::vector<Point> start(int step) const { return moved(shape.points, {0.1 * kEdge * step, 0, 0}); }
  std::vector<Point> end(int step) const { return moved(shape.points, {0.1 * kEdge * (step + 1), 0, -0.1 * kEdge}); }
};

/// The cloth and the part of the floor under it, in one mesh: the cost of the contacts between them alone.
void cloth_on_its_part_of_the_floor(const Cloth& cloth, int steps) {
  scenes::Shape all = sheet(121, 0.01, floor_height);
  const std::vector<Point> floor = all.points;
  const auto first = static_cast<Index>(floor.size());
  std::vector<Index> group(floor.size(), 0);
  group.resize(floor.size() + cloth.shape.points.size(), 1);
  for (const Face& f : cloth.shape.faces) all.faces.push_back({first + f[0], first + f[1], first + f[2]});
  Options asked = options();
  asked.filter = PairFilter::no_self_contact(group);
  Detector detector(Mesh(static_cast<Index>(group.size()), all.faces), asked);
  std::vector<Point> start, end;
  std::size_t found = 0;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        start = end = floor;
        const std::vector<Point> from = cloth.start(step), to = cloth.end(step);
        start.insert(start.end(), from.begin(), from.end());
        end.insert(end.end(), to.begin(), to.end());
      },
      [&] {
        found = detector.contacts({start, end}).size();
      });
  print_row("that cloth against the part of the floor under it, one mesh", found, cost);
}

}  // namespace

void room(int steps) {
  const Cloth cloth;
  Detector alone(Mesh(static_cast<Index>(cloth.shape.points.size()), cloth.shape.faces), options());
  std::vector<Point> start, end;
  std::size_t found = 0;
  const auto move = [&](int step) {
    start = cloth.start(step);
    end = cloth.end(step);
  };
  const Cost of_cloth = milliseconds(steps, move, [&] { found = alone.contacts({start, end}).size(); });
  print_row("cloth of 20,000 triangles with itself, a detector", found, of_cloth);
  cloth_on_its_part_of_the_floor(cloth, steps);
  const scenes::Shape floor = sheet(707, 0.01, floor_height);
  const Shape room = shape_of(floor);
  World world(options());
  world.add(room, Static{});
  const BodyId body = world.add(shape_of(cloth.shape), Deforming{cloth.start(0), cloth.end(0)});
  const Cost both = milliseconds(
      steps,
      [&](int step) {
        world.move(body, Deforming{cloth.start(step), cloth.end(step)});
      },
      [&] { found = world.contacts().size(); });
  print_row("both in a room of 999,698 triangles, a world", found, both);
  std::printf("\nThe room takes %.1f bytes a triangle beside its mesh.\n\n",
              static_cast<double>(room.memory_bytes()) / static_cast<double>(floor.faces.size()));
}

}  // namespace tamis::worlds
