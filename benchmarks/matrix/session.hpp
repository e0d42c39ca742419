// Asks the questions of one cell: counts, answers and times.
#pragma once
#include <time.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "matrix/cells.hpp"
#include "scenes/scene.hpp"
#include "tamis/detector.hpp"

namespace tamis::matrix {

/// Sums over the questions of a cell.
struct Outcome {
  std::map<std::string, std::uint64_t> counts;  ///< nodes, pairs that enter each stage, pairs decided by exact algebra
  std::uint64_t contacts = 0;
  std::uint64_t pairs = kHashSeed;   ///< hash of the pairs that touch: the same for every version
  std::uint64_t bits = kHashSeed;    ///< hash of the whole answer, times included
  std::vector<double> lower, upper;  ///< of each question: the bracket of the first time
  std::vector<double> seconds;       ///< of each question

  static constexpr std::uint64_t kHashSeed = 0xcbf29ce484222325;
};

class Session {
 public:
  /// `scene` as load_scene returns it; its motion is scaled here. Only threads and isa of the options are used. `clock`
  /// gives the seconds.
  Session(const Cell& cell, scenes::Scene scene, const Options& options, clockid_t clock);
  /// Asks all questions of the cell. Later calls use the same detector, unless the cell's state is `fresh`.
  Outcome run();

 private:
  void ask(Question question, const std::vector<Point>& start, const std::vector<Point>& end, Outcome& outcome);

  Cell cell_;
  scenes::Scene scene_;
  Mesh mesh_;
  Options options_;
  clockid_t clock_;
  double distance_;  ///< the cell's separation, in the unit of the positions
  std::vector<Point> other_start_, other_end_;
  std::optional<Detector> detector_;
};

}  // namespace tamis::matrix
