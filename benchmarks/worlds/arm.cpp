// A planner's questions about the motions of an arm.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include "tamis/linkage.hpp"
#include "worlds/rows.hpp"

namespace tamis::worlds {

namespace {

/// Seven links of 300 triangles. Each turns in the frame of the one before it.
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
  static Linkage linkage(const std::vector<BodyId>& links) {
    std::vector<Joint> joints;
    std::vector<CarriedBody> bodies;
    for (std::size_t k = 0; k < kJoints; ++k) {
      const auto number = static_cast<Index>(k);
      joints.push_back({number - 1, joint(k, 0), JointKind::turning, joint(k, 1).rotation, number});
      bodies.push_back({links[k], number, {}});
    }
    return {std::move(joints), std::move(bodies)};
  }
};

using Random = std::mt19937_64;
double any(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }

/// Adds forty balls that stand around the arm; none stands on it.
void add_balls(World& world, Random& random) {
  scenes::Shape ball = scenes::unit_sphere(9);
  for (Point& p : ball.points)
    for (double& x : p) x *= 0.15;
  const Shape obstacle = shape_of(ball);
  for (int i = 0; i < 40; ++i) {
    const double x = 2.5 * any(random), y = 2.5 * any(random), z = 0.3 + std::fabs(2 * any(random));
    Pose place{{x, y, z}, {}};
    if (std::hypot(x, y, z) < 0.8) place.position[0] += 1.6;
    world.add(obstacle, Static{place});
  }
}

/// Adds the links. Neighbours meet in their joint, and the first link stands on the floor: such contacts do not count.
std::vector<BodyId> add_arm(World& world, const Arm& robot, BodyId floor) {
  std::vector<BodyId> links;
  for (std::size_t k = 0; k < Arm::kJoints; ++k) {
    links.push_back(world.add(robot.link, Static{}));
    if (k > 0) world.set_may_touch(links[k - 1], links[k], false);
  }
  world.set_may_touch(floor, links[0], false);
  return links;
}

struct Edges {
  std::vector<double> starts, ends;
};
/// Edges from random configurations by `way` radians.
Edges edges_by(double way, int count, Random& random) {
  Edges edges;
  for (int i = 0; i < count; ++i)
    for (std::size_t k = 0; k < Arm::kJoints; ++k) {
      edges.starts.push_back(1.5 * any(random));
      edges.ends.push_back(edges.starts.back() + way / std::sqrt(7.) * any(random));
    }
  return edges;
}

/// Calls f(), and returns how often it would be done in a second of wall-clock time.
template <class F>
double rate(int count, const F& f) {
  const auto begin = std::chrono::steady_clock::now();
  f();
  return count / std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void arm_row(int threads, double way, int count) {
  Random random(7);
  Options options;
  options.threads = threads;
  World world(options);
  const BodyId floor = world.add(shape_of(sheet(100, 0.1, floor_height)), Static{});
  add_balls(world, random);
  const Arm robot;
  const std::vector<BodyId> links = add_arm(world, robot, floor);
  const Edges edges = edges_by(way, count, random);
  const Linkage linkage = Arm::linkage(links);
  std::vector<EarliestBodyContact> found;
  std::vector<bool> free;
  std::vector<EdgeAnswer> answers;
  const double many =
      rate(count, [&] { found = world.earliest_many(links, linkage.motions(edges.starts, edges.ends)); });
  const double are_free = rate(count, [&] { free = world.edges_are_free(linkage, edges.starts, edges.ends); });
  const double last = rate(count, [&] { answers = world.last_valid(linkage, edges.starts, edges.ends); });
  const auto untouched = std::ranges::count_if(found, [](const auto& first) { return !first.contact; });
  std::printf("| %d | %.1f | %d | %td | %td | %.0f | %.0f | %.0f |\n", threads, way, count, untouched,
              std::ranges::count(free, true), many, are_free, last);
}

}  // namespace

/// An arm over a floor of 20,000 triangles, among forty balls of 972 triangles. A planner asks about motions from
/// random configurations by so many radians. Prints motions a second of wall-clock time. Motions that begin inside
/// touch nothing and are not free.
void arm(int steps) {
  std::printf(
      "\n| threads | radians | motions of an arm | touch nothing | free | `earliest_many`, a second | "
      "`edges_are_free` | `last_valid` |\n|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const int threads : {1, 2})
    for (const double way : {0.1, 0.5, 3.}) arm_row(threads, way, 20 * steps);
}

}  // namespace tamis::worlds
