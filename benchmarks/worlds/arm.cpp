// A planner's questions about the motions of an arm.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

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
  /// Adds the motions of all links from one configuration to the other.
  static void add_motion(const Angles& start, const Angles& end, std::vector<BodyMotion>& motions) {
    RigidChain chain;
    for (std::size_t k = 0; k < kJoints; ++k) {
      chain.push_back({joint(k, start[k]), joint(k, end[k])});
      motions.emplace_back(Rigid{chain});
    }
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

/// Motions from random configurations by `way` radians.
std::vector<BodyMotion> motions_by(double way, int count, Random& random) {
  std::vector<BodyMotion> motions;
  for (int i = 0; i < count; ++i) {
    Arm::Angles start{}, end{};
    for (std::size_t k = 0; k < Arm::kJoints; ++k) {
      start[k] = 1.5 * any(random);
      end[k] = start[k] + way / std::sqrt(7.) * any(random);
    }
    Arm::add_motion(start, end, motions);
  }
  return motions;
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
  const std::vector<BodyMotion> motions = motions_by(way, count, random);
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<EarliestBodyContact> found = world.earliest_many(links, motions);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto free = std::ranges::count_if(found, [](const auto& first) { return !first.contact; });
  std::printf("| %d | %.1f | %d | %td | %.0f |\n", threads, way, count, free, count / seconds.count());
}

}  // namespace

/// An arm over a floor of 20,000 triangles, among forty balls of 972 triangles. A planner asks about motions from
/// random configurations by so many radians. Prints motions a second of wall-clock time.
void arm(int steps) {
  std::printf("\n| threads | radians | motions of an arm | free | a second |\n|--:|--:|--:|--:|--:|\n");
  for (const int threads : {1, 2})
    for (const double way : {0.1, 0.5}) arm_row(threads, way, 20 * steps);
}

}  // namespace tamis::worlds
