// tamis-lab queries: single vertex-face and edge-edge queries with known exact answers, straight or of rigid bodies.
#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <memory>

#include "command/command_line/arguments.hpp"
#include "command/command_line/printable.hpp"
#include "command/output_file.hpp"
#include "paper/command/query_score.hpp"
#include "paper/command/verbs.hpp"
#include "paper/queries/queries.hpp"
#include "paper/queries/query_results_csv.hpp"

namespace tamis::lab {
namespace {

class Queries final : public cli::Verb {
 public:
  const char* name() const override { return "queries"; }
  const char* summary() const override { return "Answers single queries and compares with the answers in the files"; }
  const char* examples() const override {
    return "  tamis-lab queries data/queries\n"
           "  tamis-lab queries data/queries/erleben-* --repeat 9\n"
           "  tamis-lab queries mine/edge-edge/q.csv --json\n"
           "  tamis-lab queries data/rigid --out answers.csv\n\n"
           "A CSV file has eight rows a query and the columns numerator, denominator of x, of y, of z, and\n"
           "optionally the exact answer, 0 or 1. A JSON file has one query: features of two rigid bodies, each\n"
           "with its poses at t=0 and t=1; its answer is looked for in a truth.csv beside it or above.\n"
           "Exit code 1: an answer is wrong.";
  }
  void declare(cli::OptionList& options) override {
    options.add_texts("FILES_OR_FOLDERS", names_, "CSV files below a folder named vertex-face or edge-edge; JSON files")
        .required();
    cli::declare_min_separation(options, min_separation_);
    cli::declare_repeat(options, repeat_,
                        "take each query's median time of N runs, after one that warms up; default 1");
    cli::declare_output(options, out_, "write every answer there, as CSV: file, kind, touches, toi_lower, toi_upper");
    cli::declare_json(options, json_);
  }

  int run() override {
    const PairOptions options{min_separation_};
    const auto files = query_files(names_);
    cli::require_output(out_, paths_of(files), json_, "csv");
    const std::map<std::string, QueryScore> folders = answer_all(files, options);
    QueryScore total;
    for (const auto& [name, score] : folders) total.add(score);
    if (json_)
      print_as_json(folders, total);
    else
      print_table(folders, total);
    return is_judged_positive() && !total.keeps_promise() ? cli::kNo
           : total.false_negatives > 0                    ? cli::kNo
                                                          : cli::kSuccess;
  }

 private:
  static std::vector<std::filesystem::path> paths_of(const std::vector<QueryFile>& files) {
    std::vector<std::filesystem::path> paths;
    for (const QueryFile& file : files) paths.push_back(file.path);
    return paths;
  }

  /// Returns scores by folder; writes the answers to `out_`, if that is not empty.
  std::map<std::string, QueryScore> answer_all(const std::vector<QueryFile>& files, const PairOptions& options) const {
    std::map<std::string, QueryScore> folders;
    std::vector<QueryResult> table;
    for (const QueryFile& file : files) {
      const auto queries = read_queries(file);
      std::vector<PairResult> results;
      folders[file.folder].add(answer(queries, options, repeat_, results));
      for (std::size_t i = 0; i < queries.size() && !out_.empty(); ++i)
        table.push_back({file.name, std::visit([](const auto& q) { return q.kind; }, queries[i]), results[i]});
    }
    if (!out_.empty()) write_query_results_csv(out_, table);
    return folders;
  }

  /// With a minimum separation, false positives cannot be told: the answers in the files are for distance zero.
  bool is_judged_positive() const { return min_separation_ == 0; }

  cli::Json json_of_score(const QueryScore& s) const {
    const Percentiles ns = percentiles_of(s.nanoseconds);
    const bool is_labelled = s.labelled > 0;
    return {{"queries", s.queries},
            {"contacts", s.contacts},
            {"false_positives", is_labelled && is_judged_positive() ? cli::Json(s.false_positives) : cli::Json()},
            {"false_negatives", is_labelled ? cli::Json(s.false_negatives) : cli::Json()},
            {"unresolved", s.unresolved},
            {"ns", {{"mean", ns.mean}, {"p50", ns.p50}, {"p99", ns.p99}, {"max", ns.max}}}};
  }

  void print_as_json(const std::map<std::string, QueryScore>& folders, const QueryScore& total) const {
    cli::Json json = json_of_score(total);
    json["min_separation"] = min_separation_;
    json["folders"] = cli::Json::object();
    for (const auto& [name, score] : folders) json["folders"][name] = json_of_score(score);
    cli::print_json(json);
  }

  void print_table(const std::map<std::string, QueryScore>& folders, const QueryScore& total) const {
    std::size_t width = 6;
    for (const auto& [name, score] : folders) width = std::max(width, cli::printable(name).size());
    fmt::print("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9} {:>9} {:>9} {:>9}\n", "", width, "", "", "false", "false",
               "", "ns", "ns", "ns", "ns");
    fmt::print("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9} {:>9} {:>9} {:>9}\n", "folder", width, "queries",
               "contacts", "positives", "negatives", "unresolved", "mean", "median", "p99", "max");
    for (const auto& [name, score] : folders) print_row(name, width, score);
    print_row("total", width, total);
  }

  void print_row(const std::string& name, std::size_t width, const QueryScore& s) const {
    const Percentiles ns = percentiles_of(s.nanoseconds);
    const bool is_labelled = s.labelled > 0;
    fmt::print("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9.0f} {:>9.0f} {:>9.0f} {:>9.0f}\n", cli::printable(name),
               width, cli::grouped(s.queries), cli::grouped(s.contacts),
               is_labelled && is_judged_positive() ? cli::grouped(s.false_positives) : "-",
               is_labelled ? cli::grouped(s.false_negatives) : "-", cli::grouped(s.unresolved), ns.mean, ns.p50, ns.p99,
               ns.max);
  }

  std::vector<std::string> names_;
  std::filesystem::path out_;
  double min_separation_ = 0;
  int repeat_ = 1;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<cli::Verb> make_queries() { return std::make_unique<Queries>(); }

}  // namespace tamis::lab
