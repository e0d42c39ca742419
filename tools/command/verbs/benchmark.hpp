// One measurement of a verb `bench`: one question about one step, one way of answering it.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "command/report.hpp"
#include "tamis/detector.hpp"

namespace tamis::cli {

/// A mesh, and where it is at both ends of its step.
struct BenchmarkCase {
  std::string name;
  Mesh mesh;
  std::vector<Point> start, end;
};

/// A way of answering: the library, or what is compared with it.
struct BenchmarkWay {
  std::vector<std::pair<std::string, std::string>> columns;  ///< of the table: name and value that tell it from others
  std::function<Detector(const Mesh&, const Options&)> make_detector = [](const Mesh& mesh, const Options& options) {
    return Detector(mesh, options);
  };
};

struct BenchmarkSetup {
  std::string question;  ///< one of benchmark_questions()
  double keep = 0.1;     ///< of safe-step
  BenchmarkWay way = {};
  std::string mode = "warm";  ///< what the kept detector was asked before: see benchmark_modes()
  int substeps = 20;          ///< of mode substeps
  Options options;
  int cold = 3;     ///< detectors made anew, each asked once
  int warm_up = 1;  ///< questions to the last of these detectors that are not timed
  int repeat = 9;   ///< questions to that detector that are timed
};

struct BenchmarkResult {
  Seconds cold, warm;                 ///< wall clock, the run of median total
  double cpu_cold = 0, cpu_warm = 0;  ///< seconds of processor time of the process, medians
  /// The answer. For `contacts` the number and a fingerprint of the set, else the bracket, else 1 if free.
  std::uint64_t contacts = 0, fingerprint = 0;
  double toi_lower = 1, toi_upper = 1;
  Statistics statistics;  ///< of the last run
};

/// The questions' names.
const std::vector<std::string>& benchmark_questions();

/// warm      just asked about other positions, so that nothing remembered helps: the coordinates exchanged, x for y,
///           which leaves the hierarchy as good as it was
/// again     just asked about the same start, in the other direction
/// substeps  asked about equal parts of the step, one after the other; all of them are one run
const std::vector<std::string>& benchmark_modes();

/// Throws InvalidOptions if there is no such question, mode or instruction set.
BenchmarkResult measure(const BenchmarkCase& step, const BenchmarkSetup& setup);

/// Do both give the same answer? A time may count only if they do.
bool agree(const BenchmarkResult& a, const BenchmarkResult& b);

/// One row of the table: flat, so that it is a row of a CSV file as well.
Json row_of(const BenchmarkCase& step, double scale, const BenchmarkSetup& setup, const BenchmarkResult& result);

}  // namespace tamis::cli
