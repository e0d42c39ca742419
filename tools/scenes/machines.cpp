#include "scenes/machines.hpp"

#include <cmath>
#include <numbers>

#include "scenes/point_math.hpp"

namespace tamis::scenes {
namespace {

RigidLink standing(const Point& position, const Point& rotation = {0, 0, 0}) {
  return {{position, rotation}, {position, rotation}};
}

/// Walls of height 2 `half` along a closed polygon in the plane z = 0, in triangles.
Shape walls(const std::vector<Point>& corners, double half) {
  Shape shape;
  const auto count = static_cast<Index>(corners.size());
  for (const Point& c : corners) {
    shape.points.push_back({c[0], c[1], -half});
    shape.points.push_back({c[0], c[1], half});
  }
  for (Index i = 0; i < count; ++i) {
    const Index a = 2 * i, b = 2 * ((i + 1) % count);
    shape.faces.insert(shape.faces.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
  }
  return shape;
}

/// Teeth from radius 1 - depth to 1 + depth, as wide as the gaps less some play. The first is at the angle 0.
Shape gear(Index teeth) {
  const double tooth = 2 * std::numbers::pi / teeth, depth = 1.6 / teeth;
  std::vector<Point> corners;
  for (Index i = 0; i < teeth; ++i)
    for (const auto& [part, radius] :
         {std::pair{-0.3, 1 - depth}, {-0.1, 1 + depth}, {0.1, 1 + depth}, {0.3, 1 - depth}}) {
      const double angle = (i + part) * tooth;
      corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
  return walls(corners, 0.25);
}

/// A ring of radius 1 about z, of a wire of radius `wire`.
Shape ring(Index around, Index across, double wire) {
  Shape shape;
  for (Index i = 0; i < around; ++i)
    for (Index j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across,
                   radius = 1 + wire * std::cos(v);
      shape.points.push_back({radius * std::cos(u), radius * std::sin(u), wire * std::sin(v)});
      const Index next = (i + 1) % around * across, after = (j + 1) % across;
      const Index a = i * across + j, b = next + j, c = next + after, d = i * across + after;
      shape.faces.insert(shape.faces.end(), {{a, b, c}, {a, c, d}});
    }
  return shape;
}

Shape stretched(Shape shape, const Point& by) {
  for (Point& p : shape.points)
    for (std::size_t k = 0; k < 3; ++k) p[k] *= by[k];
  return shape;
}

}  // namespace

Machine gear_train(Index count, Index teeth, double turn, bool is_jammed) {
  Machine machine{{gear(teeth)}, {}};
  const double tooth = 2 * std::numbers::pi / teeth;
  for (Index i = 0; i < count; ++i) {
    const bool is_odd = i % 2 != 0;
    // In even wheels a tooth points at the next wheel; in odd wheels a gap points at each neighbour.
    const double start = is_odd ? std::numbers::pi + tooth / 2 : 0;
    const double end = is_jammed && i == count - 1 ? start : start + (is_odd ? -turn : turn);
    const Point place{2.05 * i, 0, 0};
    machine.parts.push_back({0, {{place, {0, 0, start}}, {place, {0, 0, end}}}});
  }
  return machine;
}

Machine nut_on_bolt(Index around, double turn, bool is_jammed) {
  const Thread bolt{8, around, 6, 1, 0.25, 0.12};
  Thread nut = bolt;
  nut.turns = 3;
  nut.radius += 0.01;
  const Point start{0, 0, bolt.pitch}, end{0, 0, bolt.pitch * (1 + (is_jammed ? 0 : turn / (2 * std::numbers::pi)))};
  return {{thread(bolt), thread(nut)}, {{0, standing({0, 0, 0})}, {1, {{start, {0, 0, 0}}, {end, {0, 0, turn}}}}}};
}

Machine chain_net(Index side, Index around, Index across, double fall) {
  Machine machine{{ring(around, across, 0.15)}, {}};
  constexpr double kApart = 3;
  const auto add = [&](const Point& place, const Point& rotation, bool is_held) {
    RigidLink way = standing(place, rotation);
    if (!is_held) {
      way.end.position[2] -= fall;
      for (std::size_t k = 0; k < 3; ++k) way.end.rotation[k] += fall * std::sin(place[0] + 2 * place[1] + double(k));
    }
    machine.parts.push_back({0, way});
  };
  for (Index i = 0; i < side; ++i)
    for (Index j = 0; j < side; ++j) {
      const double x = kApart * i, y = kApart * j;
      add({x, y, 0}, {0, 0, 0}, i == 0 || j == 0 || i == side - 1 || j == side - 1);
      if (i + 1 < side) add({x + kApart / 2, y, 0}, {std::numbers::pi / 2, 0, 0}, false);
      if (j + 1 < side) add({x, y + kApart / 2, 0}, {0, std::numbers::pi / 2, 0}, false);
    }
  return machine;
}

Machine tunnel(Index cells, double turn) {
  constexpr double kWide = 1.01;
  const Shape block = stretched(unit_cube(cells), {0.5, 1, 1});
  std::vector<Point> corners;
  for (Index side = 0; side < 4; ++side)
    for (Index i = 0; i < cells; ++i) {
      const double along = kWide * (2.0 * i / cells - 1);
      const Point c[] = {{along, -kWide, 0}, {kWide, along, 0}, {-along, kWide, 0}, {-kWide, -along, 0}};
      corners.push_back(c[side]);
    }
  Shape pipe = walls(corners, 2);
  for (Point& p : pipe.points) p = {p[2], p[0], p[1]};  // along x
  const Point askew{0.4, 0, 0};
  const RigidLink way{{{-6, 0, 0}, askew}, {{6, 0, 0}, {askew[0] + turn, 0, 0}}};
  return {{pipe, block}, {{0, standing({0, 0, 0}, askew)}, {1, way}}};
}

}  // namespace tamis::scenes
