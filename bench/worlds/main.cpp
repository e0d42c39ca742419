// What bodies cost in a world: a Markdown table; medians over steps, each from where the last one ended, processor time
// of one thread. tamis_worlds [STEPS [WHICH]]
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "scenes/machines.hpp"
#include "scenes/shapes.hpp"
#include "tamis/detector.hpp"
#include "tamis/world.hpp"

namespace {

using namespace tamis;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Cost {
  double median, mean;
};

/// Milliseconds of processor time; the first steps warm up. `ask(step)` is timed, `move(step)` is not.
Cost milliseconds(int steps, const std::function<void(int)>& move, const std::function<void()>& ask) {
  constexpr int kWarm = 3;
  std::vector<double> times;
  double sum = 0;
  for (int step = 0; step < kWarm + steps; ++step) {
    move(step);
    const std::clock_t start = std::clock();
    ask();
    const double time = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (step < kWarm) continue;
    times.push_back(time);
    sum += time;
  }
  return {median(times), sum / steps};
}

void print_row(const std::string& what, std::size_t answers, const Cost& cost) {
  std::printf("| %s | %zu | %.2f | %.2f |\n", what.c_str(), answers, cost.median, cost.mean);
  std::fflush(stdout);
}

Options one_thread() {
  Options options;
  options.threads = 1;
  return options;
}

/// A grid of `cells` x `cells` squares of side `edge`, in the middle, at height(x, y).
template <class Height>
scenes::Shape sheet(Index cells, double edge, const Height& height) {
  scenes::Scene scene;
  scenes::add_grid_faces(scene, 0, cells + 1, cells + 1);
  scenes::Shape shape{{}, scene.faces};
  for (Index i = 0; i <= cells; ++i)
    for (Index j = 0; j <= cells; ++j) {
      const double x = edge * (i - 0.5 * cells), y = edge * (j - 0.5 * cells);
      shape.points.push_back({x, y, height(x, y)});
    }
  return shape;
}

std::vector<Point> scaled(std::vector<Point> points, double by) {
  for (Point& p : points)
    for (double& x : p) x *= by;
  return points;
}

/// As a body with this rotation vector has it.
Point direction_of(const Point& rotation, const Point& in_body) {
  const RigidPath path({in_body}, {0}, {{{{{0, 0, 0}, rotation}, {{0, 0, 0}, rotation}}}});
  Point direction{};
  double error = 0;
  path.points_at(0, std::array<Index, 1>{0}, {&direction, 1}, {&error, 1});
  return direction;
}

double floor_height(double x, double y) { return 0.03 * std::sin(3 * x) * std::cos(2 * y); }

std::vector<Point> moved(std::vector<Point> points, const Point& by) {
  for (Point& p : points)
    for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
  return points;
}

Shape shape_of(const scenes::Shape& shape) {
  return {Mesh(static_cast<Index>(shape.points.size()), shape.faces), shape.points};
}

/// A cloth just above the floor of a large room, in waves; it slides, and sinks a little in each step, so that some of
/// it touches.
struct Cloth {
  static constexpr double kEdge = 0.01;
  scenes::Shape shape = sheet(100, kEdge, [](double x, double y) {
    return floor_height(x, y) + kEdge * (0.3 + 0.22 * std::sin(40 * x) * std::sin(30 * y));
  });

  std::vector<Point> start(int step) const { return moved(shape.points, {0.1 * kEdge * step, 0, 0}); }
  std::vector<Point> end(int step) const { return moved(shape.points, {0.1 * kEdge * (step + 1), 0, -0.1 * kEdge}); }
};

/// The cloth and so much of the floor as is under it, in one mesh: what the contacts between them cost by themselves.
void cloth_on_its_part_of_the_floor(const Cloth& cloth, int steps) {
  scenes::Shape all = sheet(121, 0.01, floor_height);
  const std::vector<Point> floor = all.points;
  const auto first = static_cast<Index>(floor.size());
  std::vector<Index> group(floor.size(), 0);
  group.resize(floor.size() + cloth.shape.points.size(), 1);
  for (const Face& f : cloth.shape.faces) all.faces.push_back({first + f[0], first + f[1], first + f[2]});
  Options options = one_thread();
  options.filter = PairFilter::no_self_contact(group);
  Detector detector(Mesh(static_cast<Index>(group.size()), all.faces), options);
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

void room(int steps) {
  const Cloth cloth;
  Detector alone(Mesh(static_cast<Index>(cloth.shape.points.size()), cloth.shape.faces), one_thread());
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
  World world(one_thread());
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

/// `count` balls in a lattice, of which each tenth has another one beside it that comes near while both turn.
void many_bodies(int count, int steps) {
  const Shape ball = shape_of(scenes::unit_sphere(9));
  World world(one_thread());
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
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        for (int body = 0; body < count; ++body) world.move(body, Rigid{chain(body, step)});
      },
      [&] { first = world.earliest(); });
  print_row("earliest of " + std::to_string(count) + " turning balls of 972 triangles, a tenth near another",
            first.contact.has_value(), cost);
}

/// Two large balls whose surfaces are rough, near each other, one turning.
void two_large_bodies(int steps) {
  scenes::Shape rough = scenes::unit_sphere(41);
  for (std::size_t v = 0; v < rough.points.size(); ++v)
    for (double& x : rough.points[v]) x *= 1 + 0.005 * std::sin(static_cast<double>(7 * v));
  const Shape ball = shape_of(rough);
  World world(one_thread());
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

/// The step of a machine, and back, and again.
void machine_row(const std::string& what, const scenes::Machine& machine, int steps) {
  World world(one_thread());
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
                     Rigid{step % 2 == 0 ? interpolated(start, end) : interpolated(end, start)});
        }
      },
      [&] { first = world.earliest(); });
  print_row("earliest of " + what + ", " + std::to_string(triangles) + " triangles", first.contact.has_value(), cost);
}

void machines(const std::string& which, int steps) {
  const bool is_all = which.empty() || which == "machines";
  if (is_all || which == "nut") {
    machine_row("a nut that turns by 0.1 radians on a bolt", scenes::nut_on_bolt(32, 0.1, false), steps);
    machine_row("a nut that turns by 1 radian on a bolt", scenes::nut_on_bolt(32, 1, false), steps);
  }
  if (!is_all) return;
  machine_row("12 gears of 24 teeth that turn by 0.1 radians", scenes::gear_train(12, 24, 0.1, false), steps);
  machine_row("a net of 280 linked rings that sag", scenes::chain_net(10, 16, 8, 0.02), steps);
  machine_row("a block that flies through a narrow tunnel", scenes::tunnel(16, 0.005), steps);
}

/// A plate that turns on another one, in a plane askew, apart by `gap` or by what rounding leaves of that.
void plate_on_plate(double gap, int steps) {
  const scenes::Shape plate = sheet(16, 0.125, [](double, double) { return 0.0; });
  const Point askew{0.3, 0.2, 0.5};
  World world(one_thread());
  world.add(shape_of(plate), Static{{{0, 0, 0}, askew}});
  const BodyId turning = world.add(shape_of({scaled(plate.points, 0.7), plate.faces}), Static{});
  const Point normal = direction_of(askew, {0, 0, 1});
  EarliestBodyContact first;
  const Cost cost = milliseconds(
      steps,
      [&](int step) {
        const Pose pose{scaled({normal}, gap)[0], askew};
        world.move(turning, Rigid{turned(pose, scaled({normal}, 0.3 + 0.01 * step)[0], pose.position)});
      },
      [&] { first = world.earliest(); });
  char text[120];
  std::snprintf(text, sizeof text, "earliest of a plate of 512 triangles that turns on another one, %g apart", gap);
  print_row(text, first.contact.has_value(), cost);
}

/// Seven links of 300 triangles, each turning in the frame of the one before it.
struct Arm {
  static constexpr std::size_t kJoints = 7;
  static constexpr double kLength = 0.35;
  using Angles = std::array<double, kJoints>;

  Shape link = [] {
    scenes::Shape ball = scenes::unit_sphere(5);
    for (Point& p : ball.points) p = {0.5 * kLength * (p[0] + 1), 0.06 * p[1], 0.06 * p[2]};
    return shape_of(ball);
  }();

  static Pose joint(std::size_t number, double angle) {
    constexpr std::array<std::size_t, kJoints> axes{2, 1, 1, 0, 1, 0, 1};
    Pose pose{{number == 0 ? 0 : kLength, 0, number == 0 ? 0.2 : 0}, {}};
    pose.rotation[axes[number]] = angle;
    return pose;
  }
  /// Of all links, from one configuration to the other.
  static void add_motion(const Angles& start, const Angles& end, std::vector<BodyMotion>& motions) {
    Chain chain;
    for (std::size_t k = 0; k < kJoints; ++k) {
      chain.push_back({joint(k, start[k]), joint(k, end[k])});
      motions.emplace_back(Rigid{chain});
    }
  }
};

/// An arm over a floor of 20,000 triangles among forty balls of 972, as a planner asks about it: from random
/// configurations by so many radians. Motions a second of wall-clock time.
void arm(int steps) {
  const int count = 20 * steps;
  std::printf("\n| threads | radians | motions of an arm | free | a second |\n|--:|--:|--:|--:|--:|\n");
  for (const int threads : {1, 2})
    for (const double way : {0.1, 0.5}) {
      std::mt19937_64 random(7);
      std::uniform_real_distribution<double> any(-1, 1);
      Options options;
      options.threads = threads;
      World world(options);
      const BodyId floor = world.add(shape_of(sheet(100, 0.1, floor_height)), Static{});
      scenes::Shape ball = scenes::unit_sphere(9);
      for (Point& p : ball.points)
        for (double& x : p) x *= 0.15;
      const Shape obstacle = shape_of(ball);
      for (int i = 0; i < 40; ++i) {
        Pose place{{2.5 * any(random), 2.5 * any(random), 0.3 + std::fabs(2 * any(random))}, {}};
        if (std::hypot(place.position[0], place.position[1], place.position[2]) < 0.8) place.position[0] += 1.6;
        world.add(obstacle, Static{place});
      }
      const Arm robot;
      std::vector<BodyId> links;
      for (std::size_t k = 0; k < Arm::kJoints; ++k) {
        links.push_back(world.add(robot.link, Static{}));
        if (k > 0) world.set_may_touch(links[k - 1], links[k], false);
      }
      world.set_may_touch(floor, links[0], false);
      std::vector<BodyMotion> motions;
      for (int i = 0; i < count; ++i) {
        Arm::Angles start{}, end{};
        for (std::size_t k = 0; k < Arm::kJoints; ++k) {
          start[k] = 1.5 * any(random);
          end[k] = start[k] + way / std::sqrt(7.) * any(random);
        }
        Arm::add_motion(start, end, motions);
      }
      const auto begin = std::chrono::steady_clock::now();
      const std::vector<EarliestBodyContact> found = world.earliest_many(links, motions);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
      const auto free = std::ranges::count_if(found, [](const auto& first) { return !first.contact; });
      std::printf("| %d | %.1f | %d | %td | %.0f |\n", threads, way, count, free, count / seconds.count());
    }
}

}  // namespace

/// Which: two, many (or one of its numbers of bodies), machines (or nut), plates, room, or arm; all without one.
int main(int count, char** arguments) {
  const std::string which = count > 2 ? arguments[2] : "";
  const int steps = std::max(1, count > 1 ? std::atoi(arguments[1]) : 20);
  if (which != "arm") std::printf("| question | answers | ms, median | mean |\n|---|--:|--:|--:|\n");
  if (which.empty() || which == "two") two_large_bodies(steps);
  for (const int bodies : {1000, 10000})
    if (which.empty() || which == "many" || which == std::to_string(bodies)) many_bodies(bodies, steps);
  machines(which, steps);
  if (which.empty() || which == "plates")
    for (const double gap : {1e-6, 1e-10, 1e-13}) plate_on_plate(gap, steps);
  if (which.empty() || which == "room") room(steps);
  if (which.empty() || which == "arm") arm(steps);
  return 0;
}
