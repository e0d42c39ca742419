// A planner's edges: proven by Tamis, sampled by coal, on the same meshes. Prints Markdown tables.
// tamis_planners [EDGES [TRIANGLES [THREADS]]]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "planners/scene.hpp"

namespace tamis::planners {
namespace {

Shape shape_of(const scenes::Shape& shape) {
  return {Mesh(static_cast<Index>(shape.points.size()), shape.faces), shape.points};
}

/// The scene in a world.
struct Proven {
  World world;
  std::vector<CarriedBody> links;
  Linkage linkage;

  Proven(const Scene& scene, const Options& options)
      : world(options), links(add_to(world, scene)), linkage(scene.joints, links) {}

  static std::vector<CarriedBody> add_to(World& world, const Scene& scene) {
    std::vector<CarriedBody> links;
    for (std::size_t k = 0; k < scene.links.size(); ++k)
      links.push_back({world.add(shape_of(scene.links[k]), Static{}), static_cast<Index>(k), {}});
    for (std::size_t i = 0; i < links.size(); ++i)
      for (std::size_t k = i + 1; k < links.size(); ++k)
        if (std::ranges::find(scene.self_pairs, std::array{i, k}) == scene.self_pairs.end())
          world.set_may_touch(links[i].body, links[k].body, false);
    for (const scenes::Shape& obstacle : scene.obstacles) world.add(shape_of(obstacle), Static{});
    world.set_may_touch(links[0].body, links.back().body + 1, false);  // the first link stands on the table
    return links;
  }
};

/// Processor time, of all threads together.
template <class F>
Answer timed(const char* method, const F& is_free) {
  const std::clock_t begin = std::clock();
  std::vector<bool> free = is_free();
  return {method, std::move(free), static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC};
}

/// The plain questions: `has_overlap` and `is_free` of each motion.
std::vector<bool> plain(Proven& proven, const Edges& edges) {
  std::vector<bool> free;
  for (std::size_t i = 0; i < edges.count(); ++i) {
    const auto row = [&](const std::vector<double>& all) { return std::span(all).subspan(i * kAxes, kAxes); };
    proven.world.move_many(proven.linkage.bodies(), proven.linkage.motions(row(edges.starts), row(edges.ends)));
    free.push_back(!proven.world.has_overlap() && proven.world.is_free());
  }
  return free;
}

/// The first edges whose starts are free, as all are that a planner asks about.
Edges with_free_starts(Proven& proven, const Edges& edges, std::size_t count) {
  const std::vector<bool> is_free = proven.world.configurations_are_free(proven.linkage, edges.starts);
  Edges kept;
  for (std::size_t i = 0; i < edges.count() && kept.count() < count; ++i) {
    if (!is_free[i]) continue;
    const auto first = static_cast<std::ptrdiff_t>(i * kAxes), last = first + static_cast<std::ptrdiff_t>(kAxes);
    kept.starts.insert(kept.starts.end(), edges.starts.begin() + first, edges.starts.begin() + last);
    kept.ends.insert(kept.ends.end(), edges.ends.begin() + first, edges.ends.begin() + last);
  }
  return kept;
}

void compare(const Scene& scene, const char* what, const Edges& drawn, std::size_t count, int threads) {
  Options options;
  options.threads = threads;
  Proven proven(scene, options);
  const Edges edges = with_free_starts(proven, drawn, count);
  std::vector<Answer> answers;
  answers.push_back(timed("Tamis, `edges_are_free`",
                          [&] { return proven.world.edges_are_free(proven.linkage, edges.starts, edges.ends); }));
  answers.push_back(timed("the same, starts known", [&] {
    return proven.world.edges_are_free(proven.linkage, edges.starts, edges.ends, {.starts_are_free = true});
  }));
  answers.push_back(timed("Tamis, `last_valid`", [&] {
    std::vector<bool> free;
    for (const EdgeAnswer& answer : proven.world.last_valid(proven.linkage, edges.starts, edges.ends))
      free.push_back(answer.is_free());
    return free;
  }));
  answers.push_back(timed("Tamis, `has_overlap` and `is_free`, one by one", [&] { return plain(proven, edges); }));
  for (Answer& answer : sampled(scene, edges, {10, 100, 1000})) answers.push_back(std::move(answer));
  std::printf("\n%s: %zu edges, %zu triangles a link\n\n", what, edges.count(), scene.links[0].faces.size());
  std::printf("| method | free | free, and not proven | edges a second |\n|---|--:|--:|--:|\n");
  const std::vector<bool>& truth = answers[0].is_free;
  for (const Answer& answer : answers) {
    std::size_t missed = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) missed += answer.is_free[i] && !truth[i];
    std::printf("| %s | %td | %zu | %.0f |\n", answer.method.c_str(), std::ranges::count(answer.is_free, true), missed,
                static_cast<double>(edges.count()) / answer.seconds);
  }
}

}  // namespace
}  // namespace tamis::planners

int main(int count, char** arguments) {
  using namespace tamis::planners;
  const auto number = [&](int i, int otherwise) {
    return std::max(1, count > i ? std::atoi(arguments[i]) : otherwise);
  };
  const Scene scene = make_scene(number(2, 500));
  const auto edges = static_cast<std::size_t>(number(1, 1000));
  const int threads = number(3, 1);
  const std::size_t drawn = 8 * edges;
  compare(scene, "Edges of 0.3 radians", random_edges(drawn, 0.3, 1), edges, threads);
  compare(scene, "Edges of 1 radian", random_edges(drawn, 1, 2), edges, threads);
  compare(scene, "Edges between random configurations", random_edges(drawn, 0, 3), edges, threads);
  return 0;
}
