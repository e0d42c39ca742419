// What a simulator asks beside contacts, of one step: lists of pairs, what is near, what intersects, how far each
// vertex may go. tamis_questions START END [REPEAT], or SCENE TRIANGLES [REPEAT]: a Markdown table; medians, processor
// time of one thread, warm.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "io/mesh_file.hpp"
#include "scenes/scene_list.hpp"
#include "tamis/detector.hpp"

namespace {

using namespace tamis;

/// Median of the processor time in milliseconds; `ask` runs once before.
template <class Ask>
double milliseconds(int repeat, const Ask& ask) {
  std::vector<double> times;
  for (int run = 0; run <= repeat; ++run) {
    const std::clock_t start = std::clock();
    ask();
    if (run > 0) times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::nth_element(times.begin(), times.begin() + repeat / 2, times.end());
  return times[static_cast<std::size_t>(repeat / 2)];
}

void print_row(const std::string& question, std::size_t answers, double ms) {
  std::printf("| %s | %zu | %.2f |\n", question.c_str(), answers, ms);
}

double mean_edge(const Mesh& mesh, const std::vector<Point>& points) {
  double sum = 0;
  for (const auto& [a, b] : mesh.edges()) {
    const Point &p = points[static_cast<std::size_t>(a)], &q = points[static_cast<std::size_t>(b)];
    sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }
  return sum / static_cast<double>(mesh.edges().size());
}

struct Bench {
  Detector detector;
  Step step;
  int repeat;

  /// The step's own contacts, as if a broad phase had found them.
  void list_of_pairs() {
    std::vector<Pair> pairs;
    for (const Contact& c : detector.contacts(step)) pairs.push_back({c.kind, c.vertices});
    std::vector<PairResult> results(pairs.size());
    PairListOptions options;
    options.threads = 1;
    const double ms = milliseconds(repeat, [&] { narrow_phase(pairs, step, results, options); });
    const auto touching = std::count_if(results.begin(), results.end(), [](const auto& r) { return r.touches; });
    print_row("narrow_phase of the contacts, each", static_cast<std::size_t>(touching), ms);
  }

  void at_rest(double edge) {
    const Step still{step.start, step.start};
    std::size_t found = 0;
    double ms = milliseconds(repeat, [&] { found = detector.is_free(still) ? 0 : 1; });
    print_row("is_free, nothing moves", found, ms);
    ms = milliseconds(repeat, [&] { found = detector.intersections(step.start).size(); });
    print_row("intersections", found, ms);
    for (const double part : {0.01, 0.1, 0.5}) {
      ms = milliseconds(repeat, [&] { found = detector.near(step.start, part * edge).size(); });
      print_row("near, within " + std::to_string(part).substr(0, 4) + " mean edges", found, ms);
    }
  }

  /// How far all vertices go, against how far one step for all would take them.
  void own_steps() {
    TruncatedStep truncated;
    double ms = milliseconds(repeat, [&] { detector.keep_distance(step, 0.1); });
    const SafeStep together = detector.keep_distance(step, 0.1);
    print_row("keep_distance, 0.1", 1, ms);
    ms = milliseconds(repeat, [&] { truncated = detector.truncate(step, 0.1); });
    print_row("truncate, 0.1", truncated.positions.size(), ms);
    double went = 0, whole = 0;
    for (const Index v : detector.mesh().points()) {
      const double *from = step.start[v], *to = step.end[v];
      const Point& at = truncated.positions[static_cast<std::size_t>(v)];
      went += std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]);
      whole += std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    }
    std::printf("\nOf the way to the end, summed over the vertices: together %.4f, each its own %.4f.\n",
                together.lower, went / whole);
  }
};

/// A frame of the step, and what it is a frame of.
struct Frames {
  Mesh mesh;
  std::vector<Point> start, end;
};

bool is_scene(const std::string& name) {
  const auto recipes = scenes::recipes();
  return std::any_of(recipes.begin(), recipes.end(), [&](const auto& recipe) { return recipe.name == name; });
}

/// Two files, or a scene and its number of triangles.
Frames read_frames(const char* first, const char* second) {
  if (is_scene(first)) {
    const scenes::Scene scene = scenes::scene_by_name(first, std::atoi(second), 1);
    return {scene.mesh(), scene.start, scene.end};
  }
  io::MeshFile start = io::read_mesh(first);
  std::vector<Point> positions = start.positions;
  return {io::mesh_of(std::move(start)), std::move(positions), io::read_mesh(second).positions};
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: tamis_questions START END [REPEAT], or SCENE TRIANGLES [REPEAT]\n");
    return 2;
  }
  const Frames frames = read_frames(arguments[1], arguments[2]);
  Options options;
  options.threads = 1;
  Bench bench{
      Detector(frames.mesh, options), {frames.start, frames.end}, std::max(1, count > 3 ? std::atoi(arguments[3]) : 9)};
  std::printf("| question | answers | ms |\n|---|--:|--:|\n");
  bench.list_of_pairs();
  bench.at_rest(mean_edge(frames.mesh, frames.start));
  bench.own_steps();
  return 0;
}
