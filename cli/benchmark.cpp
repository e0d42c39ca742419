#include "cli/benchmark.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <optional>

#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

struct Run {
  Seconds wall;
  double cpu;
};

/// Sums over the threads: steadier than the wall clock where others use the machine too.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// FNV-1a over the pairs in their order, which the detector promises.
std::uint64_t fingerprint_of(const std::vector<Contact>& contacts) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 0x100000001b3; };
  for (const Contact& c : contacts) {
    add(static_cast<std::uint64_t>(c.kind));
    for (const Index v : c.vertices) add(static_cast<std::uint64_t>(v));
  }
  return hash;
}

using Ask = std::function<void(Detector&, BenchmarkResult&)>;

Ask ask_for(const std::string& question, const Step& step) {
  if (question == "contacts")
    return [step](Detector& detector, BenchmarkResult& result) {
      const std::vector<Contact>& contacts = detector.contacts(step);
      const Tally tally = tally_of(contacts);
      result.contacts = contacts.size();
      result.fingerprint = fingerprint_of(contacts);
      result.toi_lower = tally.toi_lower;
      result.toi_upper = tally.toi_upper;
    };
  if (question == "earliest")
    return [step](Detector& detector, BenchmarkResult& result) {
      const EarliestContact first = detector.earliest(step);
      result.contacts = first.contact ? 1 : 0;
      result.toi_lower = first.toi_lower;
      result.toi_upper = first.toi_upper;
    };
  if (question == "free")
    return [step](Detector& detector, BenchmarkResult& result) { result.contacts = detector.is_free(step) ? 0 : 1; };
  throw InvalidOptions(
      fmt::format("there is no question '{}': choose one of {}", question, fmt::join(benchmark_questions(), ", ")));
}

Seconds median_wall(std::vector<Run>& runs) {
  const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end(),
                   [](const Run& a, const Run& b) { return a.wall.total < b.wall.total; });
  return middle->wall;
}

double median_cpu(std::vector<Run>& runs) {
  const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end(), [](const Run& a, const Run& b) { return a.cpu < b.cpu; });
  return middle->cpu;
}

}  // namespace

const std::vector<std::string>& benchmark_questions() {
  static const std::vector<std::string> questions{"contacts", "earliest", "free"};
  return questions;
}

BenchmarkResult measure(const BenchmarkCase& step, const BenchmarkSetup& setup) {
  Options options = setup.options;
  choose_method(options, setup.method);
  const Ask ask = ask_for(setup.question, {step.start, step.end});
  BenchmarkResult result;
  std::optional<Detector> detector;
  const auto run = [&] {
    const double start = cpu_seconds();
    ask(*detector, result);
    // The fingerprint is in the processor time, a few ns a contact; the wall clock is the detector's own.
    return Run{detector->statistics().seconds, cpu_seconds() - start};
  };
  std::vector<Run> cold, warm;
  for (int i = 0; i < setup.cold; ++i) {
    detector.emplace(step.mesh, options);
    cold.push_back(run());
  }
  for (int i = 0; i < setup.warm_up; ++i) run();
  for (int i = 0; i < setup.repeat; ++i) warm.push_back(run());
  result.cold = median_wall(cold);
  result.cpu_cold = median_cpu(cold);
  result.warm = median_wall(warm);
  result.cpu_warm = median_cpu(warm);
  result.statistics = detector->statistics();
  return result;
}

bool agree(const BenchmarkResult& a, const BenchmarkResult& b) {
  return a.contacts == b.contacts && a.fingerprint == b.fingerprint && a.toi_lower <= b.toi_upper &&
         b.toi_lower <= a.toi_upper;
}

Json row_of(const BenchmarkCase& step, double scale, const BenchmarkSetup& setup, const BenchmarkResult& result) {
  const Statistics& s = result.statistics;
  Json row{{"scene", step.name},
           {"triangles", step.mesh.faces().size()},
           {"vertices", step.mesh.vertex_count()},
           {"scale", scale},
           {"question", setup.question},
           {"method", setup.method},
           {"bounding_volume",
            s.method == Method::paper ? name_of(setup.options.paper.bounding_volume) : std::string_view("own")},
           {"guarantee", name_of(setup.options.guarantee)},
           {"isa", name_of(s.isa)},
           {"threads", s.threads},
           {"seconds_cold", result.cold.total},
           {"seconds", result.warm.total},
           {"cpu_cold", result.cpu_cold},
           {"cpu", result.cpu_warm},
           {"bounds", result.warm.bounds},
           {"build_cold", result.cold.build},
           {"refit", result.warm.build},
           {"traverse", result.warm.traverse},
           {"filter", result.warm.filter},
           {"solve", result.warm.solve},
           {"contacts", result.contacts},
           {"toi_lower", result.toi_lower},
           {"toi_upper", result.toi_upper},
           {"nodes_visited", s.nodes_visited}};
  std::uint64_t candidates = 0;
  if (!s.stages.empty()) candidates = s.stages.front().vf + s.stages.front().ee;
  row["candidates"] = candidates;
  row["detector_memory_bytes"] = s.memory_bytes;
  row["peak_memory_bytes"] = peak_memory_bytes();
  return row;
}

}  // namespace tamis::cli
