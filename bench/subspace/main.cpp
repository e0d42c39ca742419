// Subspace culling on the reduced sheet: what is proven free, and what it saves, by the length of q.
// tamis_subspace [TRIANGLES]: a Markdown table; means over seeds, processor time of one thread.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "scenes/reduced_scene.hpp"
#include "tamis/detector.hpp"

namespace {

using namespace tamis;

constexpr int kSeeds = 5;

double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Cost {
  double first = 0, later = 0;  ///< milliseconds of a question
  std::size_t contacts = 0;
  std::uint64_t triangles_in_free_patches = 0, triangle_pairs = 0;

  void add(const scenes::ReducedScene& r, const Options& options) {
    Detector detector(r.scene.mesh(), options);
    for (double* sum : {&first, &later}) {
      const double start = processor_milliseconds();
      const std::size_t found = detector.contacts(r.scene.step()).size();
      *sum += (processor_milliseconds() - start) / kSeeds;
      if (sum == &later) contacts += found;
    }
    triangles_in_free_patches += detector.statistics().triangles_in_free_patches;
    triangle_pairs += detector.statistics().triangle_pairs;
  }
};

Options options_for(const scenes::ReducedScene& r, bool culls) {
  Options options;
  options.method = Method::paper;
  options.threads = 1;
  if (!culls) return options;
  options.paper.high_level = HighLevelCulling::subspace;
  options.paper.reduced_model = r.model;
  return options;
}

void print_row(Index triangles, double length) {
  Cost without, with;
  std::size_t faces = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const scenes::ReducedScene r = scenes::reduced_sheet(triangles, seed, length);
    faces = r.scene.faces.size();
    without.add(r, options_for(r, false));
    with.add(r, options_for(r, true));
  }
  std::printf("| %.2f | %zu | %.0f%% | %llu | %llu | %.1f | %.1f | %.0f |\n", length, without.contacts / kSeeds,
              100.0 * static_cast<double>(with.triangles_in_free_patches) / static_cast<double>(kSeeds * faces),
              static_cast<unsigned long long>(without.triangle_pairs / kSeeds),
              static_cast<unsigned long long>(with.triangle_pairs / kSeeds), without.later, with.later,
              with.first - without.first);
  if (with.contacts != without.contacts) std::printf("THE SETS DIFFER\n");
}

}  // namespace

int main(int count, char** arguments) {
  const Index triangles = count > 1 ? std::atoi(arguments[1]) : 10000;
  std::printf(
      "| length of q | contacts | triangles in free patches | pairs of triangles | with certificates | ms a step "
      "| with certificates | ms to make them |\n|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const double length : {0.01, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0}) print_row(triangles, length);
  return 0;
}
