// One cell, asked: what it counts, what it answers, how long it takes.
#pragma once
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
  std::uint64_t pairs = kHashSeed;   ///< hash of what touches: the same for every version
  std::uint64_t bits = kHashSeed;    ///< of all that is answered, times too
  std::vector<double> lower, upper;  ///< of each question: the bracket of the first time
  std::vector<double> seconds;       ///< of each question: processor time of one thread, of more the wall clock

  static constexpr std::uint64_t kHashSeed = 0xcbf29ce484222325;
};

class Session {
 public:
  /// `scene` as load_scene gives it, its motion not yet scaled. Of the options threads and instruction set count.
  Session(const Cell& cell, scenes::Scene scene, const Options& options);
  /// Asks all questions of the cell; again with the same detector, but where the cell wants a new one.
  Outcome run();

 private:
  void ask(Question question, const std::vector<Point>& start, const std::vector<Point>& end, Outcome& outcome);

  Cell cell_;
  scenes::Scene scene_;
  Mesh mesh_;
  Options options_;
  double distance_;  ///< of the cell's separation, in the unit of the positions
  std::vector<Point> other_start_, other_end_;
  std::optional<Detector> detector_;
};

}  // namespace tamis::matrix
