// A simulator's questions other than contacts, about one step: lists of pairs, near pairs, intersections, step lengths.
// tamis_questions START END [REPEAT], or SCENE TRIANGLES [REPEAT]: a Markdown table; medians, processor time of one
// thread, warm.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "benchmarks/mean_edge.hpp"
#include "benchmarks/timing.hpp"
#include "questions/frames.hpp"
#include "tamis/detector.hpp"

namespace {

using namespace tamis;
using bench::mean_edge, bench::median, bench::processor_milliseconds;

/// Processor time in milliseconds.
template <class Ask>
double time_of(const Ask& ask) {
  const double start = processor_milliseconds();
  ask();
  return processor_milliseconds() - start;
}

/// Median of the processor time of `repeat` runs, after one that is not timed.
template <class Ask>
double milliseconds(int repeat, const Ask& ask) {
  ask();
  std::vector<double> times;
  for (int run = 0; run < repeat; ++run) times.push_back(time_of(ask));
  return median(times);
}

void print_row(const std::string& question, std::size_t answers, double ms) {
  std::printf("| %s | %zu | %.2f |\n", question.c_str(), answers, ms);
}

struct Bench {
  Detector detector;
  Step step;
  int repeat;

  /// Decides a list of the step's own contacts, as if a broad phase had found them.
  void list_of_pairs() {
    std::vector<FeaturePair> pairs;
    for (const Contact& c : detector.contacts(step)) pairs.push_back({c.kind, c.vertices});
    std::vector<PairResult> results(pairs.size());
    PairOptions options;
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
      ms = milliseconds(repeat, [&] { found = detector.pairs_within(step.start, part * edge).size(); });
      print_row("near, within " + std::to_string(part).substr(0, 4) + " mean edges", found, ms);
    }
  }

  /// Compares how far all vertices go with how far one common step length takes them.
  void own_steps() {
    TruncatedStep truncated;
    const SafeStep together = detector.safe_step(step, 0.1);
    const double ms = milliseconds(repeat, [&] { truncated = detector.truncate(step, 0.1); });
    print_row("truncate, 0.1", truncated.positions.size(), ms);
    double went = 0, whole = 0;
    for (const Index v : detector.mesh().points()) {
      const double *from = step.start[v], *to = step.end[v];
      const Point& at = truncated.positions[static_cast<std::size_t>(v)];
      went += std::hypot(at[0] - from[0], at[1] - from[1], at[2] - from[2]);
      whole += std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    }
    std::printf("\nOf the way to the end, summed over the vertices: together %.4f, each its own %.4f.\n",
                together.toi_lower, went / whole);
  }
};

/// Times safe_step in turns with earliest. Both are first asked about the way back, so that nothing remembered helps.
void step_lengths(const bench::Frames& frames, const Options& options, int repeat, const std::string& which) {
  Detector largest(frames.mesh, options), keeping(frames.mesh, options);
  const Step way = frames.step(), back{way.end, way.start};
  for (const double fraction : {0.1, 0.2, 0.5}) {
    std::vector<double> times, ratios;
    for (int run = 0; run <= repeat; ++run) {
      (void)largest.earliest(back);
      (void)keeping.safe_step(back, fraction);
      const double other = time_of([&] { (void)largest.earliest(way); });
      times.push_back(time_of([&] { (void)keeping.safe_step(way, fraction); }));
      ratios.push_back(times.back() / other);
    }
    char question[100];
    std::snprintf(question, sizeof question, "safe_step, %.1f%s: %.1f times the largest step", fraction, which.c_str(),
                  median(ratios));
    print_row(question, 1, median(times));
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: tamis_questions START END [REPEAT], or SCENE TRIANGLES [REPEAT]\n");
    return 2;
  }
  const bench::Frames frames = bench::read_frames(arguments[1], arguments[2]);
  const int repeat = std::max(1, count > 3 ? std::atoi(arguments[3]) : 9);
  Options options;
  options.threads = 1;
  Bench asked{Detector(frames.mesh, options), frames.step(), repeat};
  std::printf("| question | answers | ms |\n|---|--:|--:|\n");
  asked.list_of_pairs();
  asked.at_rest(mean_edge(frames.mesh, frames.start));
  step_lengths(frames, options, repeat, "");
  step_lengths(bench::turned_as_a_whole(frames), options, repeat, ", turned by 60 degrees");
  if (!frames.mesh.faces().empty())
    step_lengths(bench::turned_against_each_other(frames), options, repeat, ", two turned against each other");
  asked.own_steps();
  return 0;
}
