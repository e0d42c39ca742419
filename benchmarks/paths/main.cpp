// Curved motion of a whole mesh: two bodies that turn past each other, a little apart. They are alone, above a terrain,
// or a point far away turns with one of them. And of two triangles, one of which turns far away from the other.
// tamis_paths [TRIANGLES [REPEAT]]: Markdown tables; triangles of each body, medians, processor time of one thread.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "benchmarks/timing.hpp"
#include "scenes/shapes.hpp"
#include "tamis/detector.hpp"
#include "tamis/rigid_path.hpp"

namespace {

using namespace tamis;
using bench::median, bench::processor_milliseconds;

struct Bodies {
  std::vector<Point> rest;
  std::vector<Face> faces;
  std::vector<Index> body;
};

Bodies two_spheres(Index triangles) {
  const scenes::Shape sphere = scenes::unit_sphere(scenes::sphere_cells(triangles, 1, 1000));
  Bodies bodies;
  for (const Index number : {0, 1}) {
    const auto first = static_cast<Index>(bodies.rest.size());
    bodies.rest.insert(bodies.rest.end(), sphere.points.begin(), sphere.points.end());
    bodies.body.insert(bodies.body.end(), sphere.points.size(), number);
    for (const Face& f : sphere.faces) bodies.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  return bodies;
}

/// Adds a square grid of `cells` x `cells` squares below the bodies.
void add_terrain(Bodies& bodies, Index cells, double width) {
  const auto first = static_cast<Index>(bodies.rest.size());
  const double edge = width / cells;
  for (Index i = 0; i <= cells; ++i)
    for (Index j = 0; j <= cells; ++j) {
      bodies.rest.push_back({edge * i - 0.5003 * width, edge * j - 0.4997 * width, -1.5 - (i + j) % 2});
      bodies.body.push_back(2);
    }
  scenes::Scene scene;
  scenes::add_grid_faces(scene, first, cells + 1, cells + 1);
  bodies.faces.insert(bodies.faces.end(), scene.faces.begin(), scene.faces.end());
}

struct Motion {
  double degrees, gap, approach;
};

/// The second sphere starts at the distance `gap` and comes nearer by `approach`. The terrain does not move.
RigidPath path_of(const Bodies& bodies, const Motion& motion) {
  const double distance = 2 + motion.gap, angle = motion.degrees * std::numbers::pi / 180;
  return {bodies.rest,
          bodies.body,
          {turned_chain({{0, 0, 0}, {0.3, 0.2, 0.1}}, {0, 0, angle}, {0, 0, 0}),
           turned_chain({{distance, 0, 0}, {0.1, 0.5, 0.2}}, {0, 0, -angle}, {distance - motion.approach, 0, 0}),
           turned_chain({{0, 0, 0}, {0, 0, 0}}, {0, 0, 0}, {0, 0, 0})}};
}

void print_row(const char* where, const Bodies& bodies, const Motion& motion, int repeat) {
  Options options;
  options.threads = 1;
  options.filter = PairFilter::no_self_contact(bodies.body);
  std::vector<Index> points;  // loose points
  if (bodies.body.back() == 0) points.push_back(static_cast<Index>(bodies.rest.size()) - 1);
  Detector detector({static_cast<Index>(bodies.rest.size()), bodies.faces, {}, points}, options);
  const RigidPath path = path_of(bodies, motion);
  std::vector<double> times;
  EarliestContact first;
  for (int run = 0; run <= repeat; ++run) {
    const double start = processor_milliseconds();
    first = detector.earliest(path);
    if (run > 0) times.push_back(processor_milliseconds() - start);
  }
  const PrecisionCount& pairs = detector.statistics().decided_by;
  std::printf("| %s | %.0f | %.3f | %.3f | %.9f | %llu | %.1f |\n", where, motion.degrees, motion.gap, motion.approach,
              first.toi_lower, static_cast<unsigned long long>(pairs.lanes + pairs.scalar + pairs.unresolved),
              median(times));
}

/// Two triangles at the distance 3, one of which turns by 3 radians on a circle of radius 1.
void print_row_of_triangles(double edge, double separation, int repeat) {
  std::vector<Point> points;
  for (const double x : {0.0, 1.0}) points.insert(points.end(), {{x, 0, 0}, {x + edge, 0, 0}, {x, edge, 0}});
  for (std::size_t i = 0; i < 3; ++i) points[i][2] = 3;
  const RigidPath path(points, {0, 0, 0, 1, 1, 1}, {RigidChain{}, turned_chain({}, {0, 0, 3}, {})});
  Detector detector(Mesh(6, {{0, 1, 2}, {3, 4, 5}}), {.threads = 1, .min_separation = separation});
  std::vector<double> times;
  for (int run = 0; run <= repeat; ++run) {
    const double start = processor_milliseconds();
    (void)detector.is_free(path);
    times.push_back(processor_milliseconds() - start);
  }
  std::printf("| %.0e | %.1f | %.2f |\n", edge, separation, median(times));
}

}  // namespace

int main(int count, char** arguments) {
  const Bodies alone = two_spheres(count > 1 ? std::atoi(arguments[1]) : 20000);
  const int repeat = count > 2 ? std::atoi(arguments[2]) : 9;
  Bodies above_terrain = alone, with_far_point = alone;
  add_terrain(above_terrain, 60, 1e4);
  with_far_point.rest.push_back({1e6, 0, 0});
  with_far_point.body.push_back(0);
  std::printf(
      "| where | turn by, degrees | apart by | nearer by | free until | pairs decided | ms, earliest |\n"
      "|---|--:|--:|--:|--:|--:|--:|\n");
  for (const double degrees : {30, 180})
    for (const double gap : {0.1, 0.02, 0.01, 0.003})
      for (const double approach : {0.0, 0.02}) {
        print_row("alone", alone, {degrees, gap, approach}, std::max(repeat, 1));
        print_row("above a terrain", above_terrain, {degrees, gap, approach}, std::max(repeat, 1));
        print_row("and a point far away", with_far_point, {degrees, gap, approach}, std::max(repeat, 1));
      }
  std::printf(
      "\n| edges of two triangles | separation | ms, is_free |\n"
      "|--:|--:|--:|\n");
  for (const double edge : {1.0, 1e-3, 1e-6, 1e-9})
    for (const double separation : {0.0, 0.5}) print_row_of_triangles(edge, separation, std::max(repeat, 1));
  return 0;
}
