// tamis bench; tamis-lab times other ways of answering beside the library's.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "command/command_line/arguments.hpp"
#include "command/command_line/verb.hpp"
#include "command/verbs/benchmark.hpp"

namespace tamis::cli {

class Bench : public Verb {
 public:
  const char* name() const override { return "bench"; }
  const char* summary() const override { return "Times questions about a step, on files or on generated scenes"; }
  const char* examples() const override {
    return "  tamis bench cloth1.ply cloth2.ply --threads 1,2\n"
           "  tamis bench cloth1.ply cloth2.ply --question contacts --isa best,baseline\n"
           "  tamis bench cloth1.ply cloth2.ply --scale 1,2,3,10 --out steps.csv\n"
           "  tamis bench cloth1.ply cloth2.ply --mode warm,again,substeps --substeps 20\n"
           "  tamis bench --scene folded-cloth --triangles 10000,100000,1000000 --json\n\n"
           "Every combination of the lists is a row. New: the first question of a detector, which builds its "
           "hierarchy.\n"
           "Kept: one that refits, after questions by mode: warm, about other positions; again, about the same start "
           "in\n"
           "the other direction; substeps, all parts of the step together. All times are medians in seconds; reading\n"
           "files and making scenes is not in them.\n"
           "Exit code 1: two rows of the same question and step differ in their answer.";
  }
  void declare(OptionList& options) override;
  int run() override;

 protected:
  /// Options that choose among ways of answering.
  virtual void declare_ways(OptionList&) {}
  /// The ways that were chosen. Throws InvalidOptions.
  virtual std::vector<BenchmarkWay> ways() const { return {BenchmarkWay{}}; }

 private:
  void declare_lists(OptionList& options);
  /// Everything that can be wrong, before the first second is spent.
  void check();
  BenchmarkCase from_files() const;
  BenchmarkCase from_scene(Index triangles) const;
  void measure_all(const BenchmarkCase& step, double scale);
  /// All ways of answering one question, which must agree.
  void measure_ways(const BenchmarkCase& step, double scale);
  void add_row(Json row, bool is_same);
  void print_row(const Json& row) const;
  void write_csv() const;

  std::vector<BenchmarkWay> ways_;
  BenchmarkSetup setup_;
  KeepArgument keep_;
  std::filesystem::path start_, end_, out_;
  std::string scene_;
  std::vector<Index> triangles_{100000};
  std::vector<std::string> questions_ = benchmark_questions();
  std::vector<std::string> modes_{"warm"};
  std::vector<std::string> isas_{"best"};
  std::vector<int> threads_{1};
  std::vector<double> scales_{1};
  std::uint64_t seed_ = 1;
  Option triangles_option_, seed_option_;
  bool json_ = false;
  bool agree_ = true;
  Json rows_ = Json::array();
};

}  // namespace tamis::cli
