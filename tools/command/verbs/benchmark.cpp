#include "command/verbs/benchmark.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <span>

#include "command/step_files.hpp"
#include "files/system.hpp"
#include "scenes/point_math.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

struct Run {
  Seconds wall;
  double cpu;  ///< of all threads: steadier than the wall clock if others use the machine too
};

/// FNV-1a over the pairs in their order, which the detector promises.
std::uint64_t fingerprint_of(std::span<const Contact> contacts) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 0x100000001b3; };
  for (const Contact& c : contacts) {
    add(static_cast<std::uint64_t>(c.kind));
    for (const Index v : c.vertices) add(static_cast<std::uint64_t>(v));
  }
  return hash;
}

using Ask = std::function<void(Detector&, const Step&, BenchmarkResult&)>;

Ask ask_for(const std::string& question, double keep) {
  if (question == "contacts")
    return [](Detector& detector, const Step& step, BenchmarkResult& result) {
      std::span<const Contact> contacts = detector.contacts(step);
      const Tally tally = tally_of(contacts);
      result.contacts = contacts.size();
      result.fingerprint = fingerprint_of(contacts);
      result.toi_lower = tally.toi_lower;
      result.toi_upper = tally.toi_upper;
    };
  if (question == "earliest")
    return [](Detector& detector, const Step& step, BenchmarkResult& result) {
      const EarliestContact first = detector.earliest(step);
      result.contacts = first.contact ? 1 : 0;
      result.toi_lower = first.toi_lower;
      result.toi_upper = first.toi_upper;
    };
  if (question == "is-free")
    return [](Detector& detector, const Step& step, BenchmarkResult& result) {
      result.contacts = detector.is_free(step) ? 0 : 1;
    };
  if (question == "safe-step")
    return [keep](Detector& detector, const Step& step, BenchmarkResult& result) {
      const SafeStep safe = detector.safe_step(step, keep);
      result.contacts = safe.pair ? 1 : 0;
      result.toi_lower = safe.toi_lower;
      result.toi_upper = safe.toi_upper;
    };
  throw InvalidOptions(
      fmt::format("there is no question '{}': choose one of {}", question, fmt::join(benchmark_questions(), ", ")));
}

/// One run: the times of all its questions together.
class Runner {
 public:
  Runner(const BenchmarkCase& step, const BenchmarkSetup& setup)
      : case_(step), ask_(ask_for(setup.question, setup.keep)) {
    const auto& known = benchmark_modes();
    if (std::find(known.begin(), known.end(), setup.mode) == known.end())
      throw InvalidOptions(fmt::format("there is no mode '{}': choose one of {}", setup.mode, fmt::join(known, ", ")));
    if (setup.mode == "warm") before_ = {scenes::exchanged(step.start), scenes::exchanged(step.end)};
    if (setup.mode == "again") before_ = {step.start, between(step.start, step.end, -1)};
    const int parts = setup.mode == "substeps" ? setup.substeps : 1;
    for (int i = 1; i <= parts; ++i)
      ends_.push_back(i == parts ? step.end : between(step.start, step.end, static_cast<double>(i) / parts));
  }

  void ask_before(Detector& detector) const {
    BenchmarkResult ignored;
    if (!before_.empty()) ask_(detector, {before_[0], before_[1]}, ignored);
  }

  Run run(Detector& detector, BenchmarkResult& result) const {
    Run run{};
    const double start = system::cpu_seconds();
    BenchmarkResult part;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      ask_(detector, {i == 0 ? case_.start : ends_[i - 1], ends_[i]}, part);
      add(run.wall, detector.statistics().seconds);
      add(result, part, i);
    }
    // The fingerprint is in the processor time, a few ns a contact; the wall clock is the detector's own.
    run.cpu = system::cpu_seconds() - start;
    return run;
  }

 private:
  static void add(Seconds& sum, const Seconds& part) {
    sum.total += part.total;
    sum.bounds += part.bounds;
    sum.build += part.build;
    sum.traverse += part.traverse;
    sum.filter += part.filter;
    sum.solve += part.solve;
  }

  /// The bracket of the whole step is that of its first part that is not free.
  void add(BenchmarkResult& sum, const BenchmarkResult& part, std::size_t i) const {
    if (i == 0) sum = {};
    const auto parts = static_cast<double>(ends_.size());
    if (sum.contacts == 0 && part.contacts > 0) {
      sum.toi_lower = (static_cast<double>(i) + part.toi_lower) / parts;
      sum.toi_upper = (static_cast<double>(i) + part.toi_upper) / parts;
    }
    sum.contacts += part.contacts;
    sum.fingerprint = (sum.fingerprint ^ part.fingerprint) * 0x100000001b3;
  }

  const BenchmarkCase& case_;
  const Ask ask_;
  std::vector<std::vector<Point>> before_;  ///< start and end of a question that is not timed
  std::vector<std::vector<Point>> ends_;    ///< of the timed ones
};

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
  static const std::vector<std::string> questions{"contacts", "earliest", "is-free", "safe-step"};
  return questions;
}

const std::vector<std::string>& benchmark_modes() {
  static const std::vector<std::string> modes{"warm", "again", "substeps"};
  return modes;
}

BenchmarkResult measure(const BenchmarkCase& step, const BenchmarkSetup& setup) {
  const Runner runner(step, setup);
  BenchmarkResult result;
  std::optional<Detector> detector;
  std::vector<Run> cold, warm;
  for (int i = 0; i < setup.cold; ++i) {
    detector.emplace(setup.way.make_detector(step.mesh, setup.options));
    cold.push_back(runner.run(*detector, result));
  }
  for (int i = -setup.warm_up; i < setup.repeat; ++i) {
    runner.ask_before(*detector);
    const Run run = runner.run(*detector, result);
    if (i >= 0) warm.push_back(run);
  }
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
           {"mode", setup.mode}};
  for (const auto& [name, value] : setup.way.columns) row[name] = value;
  row.update({{"isa", name_of(s.isa)},
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
              {"nodes_visited", s.nodes_visited}});
  std::uint64_t candidates = 0;
  if (!s.stages.empty()) candidates = s.stages.front().vf + s.stages.front().ee;
  row["candidates"] = candidates;
  row["detector_memory_bytes"] = s.memory_bytes;
  row["peak_memory_bytes"] = system::peak_memory_bytes();
  return row;
}

}  // namespace tamis::cli
