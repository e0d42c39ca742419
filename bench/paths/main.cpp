// Curved motion of a whole mesh: two bodies that turn past each other by 30 degrees, a little apart.
// tamis_paths [TRIANGLES [REPEAT]]: a Markdown table; triangles of each body, medians, processor time of one thread.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "scenes/shapes.hpp"
#include "tamis/detector.hpp"
#include "tamis/rigid_path.hpp"

namespace {

using namespace tamis;

double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct TwoBodies {
  std::vector<Point> rest;
  std::vector<Face> faces;
  std::vector<Index> body;
};

TwoBodies two_spheres(Index triangles) {
  const scenes::Shape sphere = scenes::unit_sphere(scenes::sphere_cells(triangles, 1, 1000));
  TwoBodies bodies;
  for (const Index number : {0, 1}) {
    const auto first = static_cast<Index>(bodies.rest.size());
    bodies.rest.insert(bodies.rest.end(), sphere.points.begin(), sphere.points.end());
    bodies.body.insert(bodies.body.end(), sphere.points.size(), number);
    for (const Face& f : sphere.faces) bodies.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  return bodies;
}

/// The second one stands `gap` away and goes nearer by `approach`.
RigidPath turning(const TwoBodies& bodies, double gap, double approach) {
  constexpr double kAngle = std::numbers::pi / 6;
  const double distance = 2 + gap;
  return {bodies.rest,
          bodies.body,
          {turned({{0, 0, 0}, {0.3, 0.2, 0.1}}, {0, 0, kAngle}, {0, 0, 0}),
           turned({{distance, 0, 0}, {0.1, 0.5, 0.2}}, {0, 0, -kAngle}, {distance - approach, 0, 0})}};
}

void print_row(const TwoBodies& bodies, double gap, double approach, int repeat) {
  Options options;
  options.threads = 1;
  options.filter = PairFilter::no_self_contact(bodies.body);
  Detector detector({static_cast<Index>(bodies.rest.size()), bodies.faces}, options);
  const RigidPath path = turning(bodies, gap, approach);
  std::vector<double> times;
  EarliestContact first;
  for (int run = 0; run <= repeat; ++run) {
    const double start = processor_milliseconds();
    first = detector.earliest(path);
    if (run > 0) times.push_back(processor_milliseconds() - start);
  }
  std::nth_element(times.begin(), times.begin() + repeat / 2, times.end());
  const PrecisionCount& pairs = detector.statistics().decided_by;
  std::printf("| %.3f | %.3f | %.9f | %llu | %.1f |\n", gap, approach, first.toi_lower,
              static_cast<unsigned long long>(pairs.lanes + pairs.scalar + pairs.unresolved),
              times[static_cast<std::size_t>(repeat / 2)]);
}

}  // namespace

int main(int count, char** arguments) {
  const TwoBodies bodies = two_spheres(count > 1 ? std::atoi(arguments[1]) : 20000);
  const int repeat = count > 2 ? std::atoi(arguments[2]) : 9;
  std::printf("| apart by | nearer by | free until | pairs decided | ms, earliest |\n|--:|--:|--:|--:|--:|\n");
  for (const double gap : {0.1, 0.02, 0.01, 0.003})
    for (const double approach : {0.0, 0.02}) print_row(bodies, gap, approach, std::max(repeat, 1));
  return 0;
}
