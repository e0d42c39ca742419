// Subspace culling on the reduced sheet, by the length of q: how much is proven free, and how much time that saves.
// tamis_subspace [TRIANGLES]: a Markdown table; means over seeds, processor time of one thread.
#include <array>
#include <cstdio>
#include <cstdlib>

#include "benchmarks/timing.hpp"
#include "paper/detector.hpp"
#include "paper/reduced_scene.hpp"

namespace {

using namespace tamis;
using bench::processor_milliseconds;

constexpr int kSeeds = 5;

struct Cost {
  double first = 0, later = 0;  ///< milliseconds of a question
  std::size_t contacts = 0;
  lab::TriangleCounts triangles;

  void add(const lab::ReducedScene& r, const lab::Options& options) {
    lab::TriangleCounts counts;
    Detector detector = lab::make_detector(r.scene.mesh(), options, &counts);
    for (double* sum : {&first, &later}) {
      const double start = processor_milliseconds();
      const std::size_t found = detector.contacts(r.scene.step()).size();
      *sum += (processor_milliseconds() - start) / kSeeds;
      if (sum == &later) contacts += found;
    }
    triangles.in_free_patches += counts.in_free_patches;
    triangles.pairs += counts.pairs;
  }
};

lab::Options options_for(const lab::ReducedScene& r, bool culls) {
  lab::Options options;
  options.method = lab::Method::paper;
  options.threads = 1;
  if (!culls) return options;
  options.paper.high_level = lab::HighLevelCulling::subspace;
  options.paper.reduced_model = r.model;
  return options;
}

void print_row(Index triangles, double length) {
  Cost without, with;
  std::size_t faces = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const lab::ReducedScene r = lab::reduced_sheet(triangles, seed, length);
    faces = r.scene.faces.size();
    without.add(r, options_for(r, false));
    with.add(r, options_for(r, true));
  }
  std::printf("| %.2f | %zu | %.0f%% | %llu | %llu | %.1f | %.1f | %.0f |\n", length, without.contacts / kSeeds,
              100.0 * static_cast<double>(with.triangles.in_free_patches) / static_cast<double>(kSeeds * faces),
              static_cast<unsigned long long>(without.triangles.pairs / kSeeds),
              static_cast<unsigned long long>(with.triangles.pairs / kSeeds), without.later, with.later,
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
