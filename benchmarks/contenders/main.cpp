// tamis_contenders: public packages and Tamis on the same step in the same run; answers are compared before times
// count.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "benchmarks/contenders/swept_boxes.hpp"
#include "benchmarks/timing.hpp"
#include "files/mesh/frames.hpp"
#include "files/mesh/mesh_file.hpp"
#include "files/mesh/mesh_formats.hpp"
#include "tamis/detector.hpp"

namespace tamis::bench {
namespace {

using Json = nlohmann::ordered_json;

Task read_task(const std::string& start, const std::string& end, double scale) {
  io::MeshFile first = io::read_mesh(start), second = io::read_mesh(end);
  io::require_same_mesh(first, start, second, end);
  std::vector<Point> from = first.positions, to = std::move(second.positions);
  if (scale != 1)
    for (std::size_t v = 0; v < to.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis) to[v][axis] = from[v][axis] + scale * (to[v][axis] - from[v][axis]);
  return {io::mesh_of(std::move(first)), std::move(from), std::move(to), {}, {}, {}};
}

/// Finds the true contacts by exact algebra.
void find_truth(Task& task) {
  Options options;
  Detector detector(task.mesh, options);
  for (const Contact& contact : detector.contacts({task.start, task.end}))
    task.contacts.insert({contact.kind, contact.vertices});
}

const char* title_of(Field field) {
  switch (field) {
    case Field::broad_phase:
      return "broad phase: boxes, build, all pairs counted";
    case Field::one_pair:
      return "pair by pair, candidates given";
    case Field::all_contacts:
      return "all contacts, end to end";
    default:
      return "first contact, end to end";
  }
}

Cost median_cost(Contender& contender, const Task& task, int repeat) {
  std::vector<double> seconds, cpu;
  contender.run(task);  // warms caches and the detectors that are kept
  for (int i = 0; i < repeat; ++i) {
    const Cost cost = contender.run(task);
    seconds.push_back(cost.seconds);
    cpu.push_back(cost.cpu);
  }
  return {median(seconds), median(cpu)};
}

Contenders all_contenders() {
  Contenders list;
#define TAMIS_CONTENDER(name) add_##name(list);
#include "benchmarks/contenders.inc"
#undef TAMIS_CONTENDER
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a->field() < b->field(); });
  return list;
}

struct Arguments {
  std::string start, end;
  double scale = 1;
  int repeat = 5;
  std::vector<int> threads{1};
  bool json = false;
};

Json row_of(Contender& contender, const Task& task, int repeat) {
  const Cost cost = median_cost(contender, task, repeat);
  const Answer answer = contender.answer(task);
  return {{"field", title_of(contender.field())},
          {"name", contender.name()},
          {"threads", task.threads},
          {"seconds", cost.seconds},
          {"cpu", cost.cpu},
          {"vf", answer.vf},
          {"ee", answer.ee},
          {"missed", answer.missed},
          {"extra", answer.extra},
          {"note", answer.note}};
}

void print_row(const Json& row, std::string& title) {
  if (title != row["field"].get<std::string>()) {
    title = row["field"];
    fmt::print("\n{}\n{:<42} {:>2} {:>10} {:>10} {:>10} {:>10} {:>8} {:>8}\n", title, "", "T", "ms", "cpu ms", "vf",
               "ee", "missed", "extra");
  }
  fmt::print("{:<42} {:>2} {:>10.2f} {:>10.2f} {:>10} {:>10} {:>8} {:>8}  {}\n", row["name"].get<std::string>(),
             row["threads"].get<int>(), 1e3 * row["seconds"].get<double>(), 1e3 * row["cpu"].get<double>(),
             row["vf"].get<std::uint64_t>(), row["ee"].get<std::uint64_t>(), row["missed"].get<std::uint64_t>(),
             row["extra"].get<std::uint64_t>(), row["note"].get<std::string>());
  std::fflush(stdout);
}

int run(const Arguments& arguments) {
  Task task = read_task(arguments.start, arguments.end, arguments.scale);
  find_truth(task);
  find_candidates(task);
  if (!arguments.json)
    fmt::print("{} triangles, {} contacts by exact algebra, {} pairs of swept boxes\n", task.mesh.faces().size(),
               task.contacts.size(), task.candidates.size());
  Json rows = Json::array();
  std::string title;
  for (const auto& contender : all_contenders())
    for (const int threads : arguments.threads) {
      if (threads != arguments.threads.front() && !contender->uses_threads()) continue;
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
      task.threads = threads;
      rows.push_back(row_of(*contender, task, arguments.repeat));
      if (!arguments.json) print_row(rows.back(), title);
    }
  if (arguments.json)
    fmt::print("{}\n", Json{{"start", arguments.start},
                            {"triangles", task.mesh.faces().size()},
                            {"contacts", task.contacts.size()},
                            {"candidates", task.candidates.size()},
                            {"rows", rows}}
                           .dump(2));
  return 0;
}

}  // namespace
}  // namespace tamis::bench

int main(int argc, char** argv) {
  CLI::App app("Public packages and Tamis on one step: answers compared, then times.", "tamis_contenders");
  tamis::bench::Arguments arguments;
  app.add_option("START", arguments.start, "the mesh at t=0: " + tamis::io::mesh_format_names())->required();
  app.add_option("END", arguments.end, "the same mesh at t=1")->required();
  app.add_option("--scale", arguments.scale, "take END = START + S (END - START)");
  app.add_option("--repeat", arguments.repeat, "timed runs each, after one that is not; default 5")
      ->check(CLI::Range(1, 1000));
  app.add_option("--threads", arguments.threads, "numbers of threads; default 1")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
  app.add_flag("--json", arguments.json, "print one JSON object");
  CLI11_PARSE(app, argc, argv);
  try {
    return tamis::bench::run(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "tamis_contenders: {}\n", error.what());
    return 2;
  }
}
