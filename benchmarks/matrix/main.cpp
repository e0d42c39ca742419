// tamis_matrix: asks cells of the matrix and prints a line of JSON for each.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "benchmarks/timing.hpp"
#include "files/mesh/wildcards.hpp"
#include "matrix/cells.hpp"
#include "matrix/scenes.hpp"
#include "matrix/session.hpp"
#include "tamis/error.hpp"

namespace tamis::matrix {
namespace {

constexpr const char* kUsage = R"(tamis_matrix [--part PART] --list [PATTERN...]              names of cells
tamis_matrix [--part PART] [--isa NAME] PATTERN...          asks each cell once: counts and a hash of the answer
tamis_matrix [--isa NAME] --serve                           cells, one a line, on stdin; an empty line asks the last
                                                            one again, timed
--threads N: of the detectors [1]. Times are processor time of one thread, of more the wall clock.
--wall: the wall clock, whatever the threads: some systems count processor time in steps of ten milliseconds.
Patterns as of the shell: 'kick*/x3/contacts/*'. A name is SCENE/xSCALE/QUESTION/STATE/dSEPARATION.
Parts: night (all, the default), daily, quick; left-out: what takes too long even for the night (--list only).
)";

/// Keeps the last scene that was asked for, as cells come scene by scene.
const scenes::Scene& scene_named(const std::string& name) {
  static scenes::Scene last;
  if (last.name != name) {
    last = load_scene(name);
    last.name = name;
  }
  return last;
}

nlohmann::ordered_json row_of(const Cell& cell, const Outcome& outcome) {
  nlohmann::ordered_json row{{"cell", name_of(cell)},
                             {"contacts", outcome.contacts},
                             {"pairs", fmt::format("{:016x}", outcome.pairs)},
                             {"bits", fmt::format("{:016x}", outcome.bits)},
                             {"seconds", std::accumulate(outcome.seconds.begin(), outcome.seconds.end(), 0.)},
                             {"lower", outcome.lower},
                             {"upper", outcome.upper},
                             {"counts", outcome.counts}};
  return row;
}

/// Milliseconds of each question of the cell: medians of as many runs as fit into a fiftieth of a second, at least one.
std::vector<double> time(Session& session) {
  constexpr double kEnough = 0.02;
  constexpr std::size_t kMostRuns = 1000;
  std::vector<std::vector<double>> of_questions;
  double sum = 0;
  for (std::size_t i = 0; i < kMostRuns && (i == 0 || sum < kEnough); ++i) {
    const Outcome outcome = session.run();
    of_questions.resize(outcome.seconds.size());
    for (std::size_t q = 0; q < outcome.seconds.size(); ++q) {
      of_questions[q].push_back(1e3 * outcome.seconds[q]);
      sum += outcome.seconds[q];
    }
  }
  std::vector<double> medians;
  for (auto& values : of_questions) medians.push_back(bench::median(std::move(values)));
  return medians;
}

/// Memory that detectors free stays with the process. Otherwise the next one has 10 page faults or 3,000, depending on
/// the order in which the last one freed its arrays: that changes the time of a cell by half, by luck.
void keep_memory() {
#if defined(M_MMAP_MAX)  // WebAssembly keeps all memory
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

void print(const nlohmann::ordered_json& row) { std::cout << row.dump() << std::endl; }

struct Arguments {
  Options options{.threads = 1};
  bool by_wall = false, lists = false, serves = false;
  std::string part = "night";
  std::vector<std::string> patterns;
};

/// With one thread the process's processor time, which other users of the machine do not change.
clockid_t clock_of(const Arguments& asked) {
  return asked.options.threads == 1 && !asked.by_wall ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
}

void serve(const Arguments& asked) {
  std::unique_ptr<Session> session;
  for (std::string line; std::getline(std::cin, line);) {
    if (!line.empty()) {
      const Cell cell = cell_from_name(line);
      session = std::make_unique<Session>(cell, scene_named(cell.scene.name), asked.options, clock_of(asked));
      print(row_of(cell, session->run()));
    } else if (session) {
      print({{"ms", time(*session)}});
    }
  }
}

bool fits(const std::string& name, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& p) { return io::matches(p, name, io::Brackets::are_sets); });
}

int number_from(const std::string& word) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size())
    throw InvalidOptions(fmt::format("'{}' is not a number of threads: give 0 (all) or a positive number", word));
  return number;
}

Arguments read(const std::vector<std::string>& words) {
  Arguments asked;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_value = i + 1 < words.size();
    if (words[i] == "--isa" && has_value)
      asked.options.isa = isa_from_name(words[++i]);
    else if (words[i] == "--threads" && has_value)
      asked.options.threads = number_from(words[++i]);
    else if (words[i] == "--part" && has_value)
      asked.part = words[++i];
    else if (words[i] == "--wall")
      asked.by_wall = true;
    else if (words[i] == "--list")
      asked.lists = true;
    else if (words[i] == "--serve")
      asked.serves = true;
    else if (words[i].starts_with("-"))
      throw InvalidOptions(fmt::format("unknown option '{}'\n{}", words[i], kUsage));
    else
      asked.patterns.push_back(words[i]);
  }
  if (asked.patterns.empty() && asked.lists) asked.patterns.emplace_back("*");
  if (asked.patterns.empty() && !asked.serves) throw InvalidOptions(fmt::format("name cells\n{}", kUsage));
  return asked;
}

std::vector<Cell> cells_of(const Arguments& asked) {
  const bool is_left_out = asked.part == "left-out";
  if (is_left_out && !asked.lists) throw InvalidOptions("cells of the part 'left-out' are listed, not asked");
  std::vector<Cell> cells = is_left_out ? cells_left_out() : cells_of(part_from_name(asked.part));
  std::erase_if(cells, [&](const Cell& cell) { return !fits(name_of(cell), asked.patterns); });
  return cells;
}

void run(const Arguments& asked) {
  if (asked.serves) return serve(asked);
  for (const Cell& cell : cells_of(asked))
    if (asked.lists)
      std::cout << name_of(cell) << '\n';
    else
      print(row_of(cell, Session(cell, scene_named(cell.scene.name), asked.options, clock_of(asked)).run()));
}

}  // namespace
}  // namespace tamis::matrix

int main(int count, char** arguments) {
  try {
    tamis::matrix::keep_memory();
    tamis::matrix::run(tamis::matrix::read({arguments + 1, arguments + count}));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "tamis_matrix: " << error.what() << '\n';
    return 1;
  }
}
