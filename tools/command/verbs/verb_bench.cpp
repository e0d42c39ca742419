// tamis bench: how long questions take, end to end, and whether every way of asking gives one answer.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "command/step_files.hpp"
#include "command/verbs/bench.hpp"
#include "files/atomic_file.hpp"
#include "files/mesh/mesh_formats.hpp"
#include "files/output/csv.hpp"
#include "files/scale_step.hpp"
#include "scenes/scene_list.hpp"
#include "tamis/error.hpp"

namespace tamis::cli {
namespace {

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void require_known(const char* what, const std::vector<std::string>& names, const std::vector<std::string>& known) {
  for (const std::string& name : names)
    if (!contains(known, name))
      throw InvalidOptions(fmt::format("there is no {} '{}': choose one of {}", what, name, fmt::join(known, ", ")));
}

}  // namespace

void Bench::declare(OptionList& options) {
  options.add_path("START", start_, "the mesh at t=0: " + io::mesh_format_names());
  options.add_path("END", end_, "the same mesh at t=1");
  declare_lists(options);
  options.add_number("--cold", "N", setup_.cold, kRunCounts,
                     "new detectors, each timed at its first question; default 3");
  options.add_number("--warm-up", "N", setup_.warm_up, {.least = 0, .most = kRunCounts.most},
                     "questions to the last of them that are not timed; default 1");
  declare_repeat(options, setup_.repeat, "questions to it that are timed; default 9");
  options.add_number("--substeps", "N", setup_.substeps, kRunCounts,
                     "equal parts of the step in mode substeps; default 20");
  declare_min_separation(options, setup_.options.min_separation);
  seed_option_ = declare_seed(options, seed_, "the generated scene");
  declare_output(options, out_, "write the rows, as CSV");
  declare_json(options, json_);
}

int Bench::run() {
  check();
  for (const Index triangles : scene_.empty() ? std::vector<Index>{0} : triangles_) {
    BenchmarkCase step = scene_.empty() ? from_files() : from_scene(triangles);
    const std::vector<Point> end = step.end;
    for (const double scale : scales_) {
      step.end = end;
      io::scale_step(step.start, step.end, scale);
      measure_all(step, scale);
    }
  }
  if (!out_.empty()) write_csv();
  if (json_) print_json({{"rows", rows_}, {"answers_agree", agree_}});
  return agree_ ? kSuccess : kNo;
}

void Bench::declare_lists(OptionList& options) {
  std::string scenes;
  for (const scenes::Recipe& recipe : scenes::recipes())
    if (recipe.scales) scenes += fmt::format("{}{}", scenes.empty() ? "" : ", ", recipe.name);
  options
      .add_text(
          "--scene", scene_,
          "a generated scene instead of files: " + scenes + ", or one of the small ones, which an unknown name lists")
      .shown_as("NAME");
  triangles_option_ =
      options.add_numbers("--triangles", "N", triangles_, {1, 100'000'000}, "its sizes; default 100000");
  options.add_names("--question", questions_, "contacts, earliest, is-free, safe-step; default all four");
  keep_.declare(options);
  options.add_names(
      "--mode", modes_,
      "earlier questions of the kept detector: warm (default), other positions; again, the same start in the "
      "other direction; substeps: parts of the step, one after the other");
  declare_ways(options);
  options.add_numbers("--threads", "N", threads_, kThreadCounts, "numbers of threads; 0: all; default 1");
  options.add_names("--isa", isas_, "best (default), baseline, avx2, avx512");
  options.add_numbers("--scale", "S", scales_, kNotNegative, "how much of the way from START to END; default 1");
}

void Bench::check() {
  for (const std::string& isa : isas_) (void)isa_from_name(isa);  // throws
  ways_ = ways();
  setup_.keep = keep_.part();
  require_known("question", questions_, benchmark_questions());
  require_known("mode", modes_, benchmark_modes());
  if (keep_.part() != KeepArgument().part() && !contains(questions_, "safe-step"))
    throw InvalidOptions("--keep is of the question safe-step: name it in --question, or leave --keep out");
  if (setup_.substeps != BenchmarkSetup().substeps && !contains(modes_, "substeps"))
    throw InvalidOptions("--substeps is of the mode substeps: name it in --mode, or leave --substeps out");
  const bool has_files = !start_.empty() && !end_.empty();
  if (has_files == !scene_.empty() || start_.empty() != end_.empty())
    throw InvalidOptions("give either START and END or --scene");
  if (has_files && (triangles_option_.is_given() || seed_option_.is_given()))
    throw InvalidOptions("--triangles and --seed are of generated scenes: give --scene instead of START and END");
  require_output(out_, {start_, end_}, true, "csv");
}

BenchmarkCase Bench::from_files() const {
  StepFiles files = read_step(start_, end_, 1);
  return {start_.stem().string(), std::move(files.mesh), std::move(files.start), std::move(files.end)};
}

BenchmarkCase Bench::from_scene(Index triangles) const {
  scenes::Scene scene = scenes::scene_by_name(scene_, triangles, seed_);
  Mesh mesh = scene.mesh();
  return {scene_, std::move(mesh), std::move(scene.start), std::move(scene.end)};
}

void Bench::measure_all(const BenchmarkCase& step, double scale) {
  for (const std::string& question : questions_)
    for (const std::string& mode : modes_) {
      setup_.question = question;
      setup_.mode = mode;
      measure_ways(step, scale);
    }
}

void Bench::measure_ways(const BenchmarkCase& step, double scale) {
  std::optional<BenchmarkResult> first;
  for (const BenchmarkWay& way : ways_)
    for (const std::string& isa : isas_)
      for (const int threads : threads_) {
        setup_.way = way;
        setup_.options.isa = isa_from_name(isa);
        setup_.options.threads = threads;
        const BenchmarkResult result = measure(step, setup_);
        if (!first) first = result;
        add_row(row_of(step, scale, setup_, result), agree(*first, result));
      }
}

void Bench::add_row(Json row, bool is_same) {
  row["agrees"] = is_same;
  agree_ = agree_ && is_same;
  if (!json_) print_row(row);
  rows_.push_back(std::move(row));
}

void Bench::print_row(const Json& row) const {
  const auto columns = [&](const auto& cell) {
    std::string text;
    for (const auto& column : setup_.way.columns) text += fmt::format("{:<16} ", cell(column));
    return text;
  };
  if (rows_.empty())
    fmt::print("{:<18} {:>10} {:>5} {:<9} {:<8} {}{:<8} {:>2} {:>10} {:>10} {:>10} {:>9}\n", "scene", "triangles",
               "scale", "question", "mode", columns([](const auto& column) { return column.first; }), "isa", "T", "new",
               "kept", "cpu kept", "contacts");
  fmt::print("{:<18} {:>10} {:>5} {:<9} {:<8} {}{:<8} {:>2} {:>10} {:>10} {:>10} {:>9}{}\n",
             printable(row["scene"].get<std::string>()), grouped(row["triangles"]), row["scale"].get<double>(),
             row["question"].get<std::string>(), row["mode"].get<std::string>(),
             columns([](const auto& column) { return column.second; }), row["isa"].get<std::string>(),
             row["threads"].get<int>(), readable(row["seconds_cold"]), readable(row["seconds"]), readable(row["cpu"]),
             grouped(row["contacts"]), row["agrees"].get<bool>() ? "" : "  DIFFERS from the first answer");
  std::fflush(stdout);
}

void Bench::write_csv() const {
  std::vector<std::string> cells;
  for (const auto& [key, value] : rows_.front().items()) cells.push_back(key);
  std::string text = fmt::format("{}\n", fmt::join(cells, ","));
  for (const Json& row : rows_) {
    cells.clear();
    for (const Json& value : row)
      cells.push_back(io::csv_cell(value.is_string() ? value.get<std::string>() : value.dump()));
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  io::AtomicFile file(out_);
  file.append(text);
  file.commit();
}

std::unique_ptr<Verb> make_bench() { return std::make_unique<Bench>(); }

}  // namespace tamis::cli
