#include "worlds/rows.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>

#include "benchmarks/timing.hpp"

namespace tamis::worlds {
namespace {

int threads_of_rows = 1;

double milliseconds_now() {
  timespec now{};
  clock_gettime(threads_of_rows == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Cost milliseconds(int steps, const std::function<void(int)>& move, const std::function<void()>& ask) {
  constexpr int kWarm = 3;
  std::vector<double> times;
  double sum = 0;
  for (int step = 0; step < kWarm + steps; ++step) {
    move(step);
    const double start = milliseconds_now();
    ask();
    const double time = milliseconds_now() - start;
    if (step < kWarm) continue;
    times.push_back(time);
    sum += time;
  }
  return {bench::median(times), sum / steps};
}

void print_row(const std::string& what, std::size_t answers, const Cost& cost) {
  std::printf("| %s | %zu | %.2f | %.2f |\n", what.c_str(), answers, cost.median, cost.mean);
  std::fflush(stdout);
}

void set_threads(int threads) { threads_of_rows = threads; }

Options options() { return {.threads = threads_of_rows}; }

scenes::Shape sheet(Index cells, double edge, const std::function<double(double, double)>& height) {
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

double floor_height(double x, double y) { return 0.03 * std::sin(3 * x) * std::cos(2 * y); }

Shape shape_of(const scenes::Shape& shape) {
  return {Mesh(static_cast<Index>(shape.points.size()), shape.faces), shape.points};
}

}  // namespace tamis::worlds
