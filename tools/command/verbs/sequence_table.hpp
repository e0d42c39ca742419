// Prints the answers for a sequence of steps: a row each and totals, or one JSON object.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "command/report.hpp"
#include "command/start_check.hpp"

namespace tamis::cli {

/// The answer to one step and what it cost. Plain data.
struct SequenceStep {
  std::size_t end;  ///< the frame to which it goes
  int part;         ///< of `substeps`, counted from 1
  Tally tally;
  Seconds seconds;
  bool rebuilt;
  bool has_collapsed;  ///< something was left out, of which nothing is proven

  bool is_free() const { return tally.is_free() && !has_collapsed; }
  /// Proven: no contact before this time.
  double free_before() const { return has_collapsed ? 0 : tally.toi_lower; }
};

class SequenceTable {
 public:
  SequenceTable(std::vector<std::filesystem::path> frames, int substeps, bool json);

  void print_head(const Detector& detector) const;
  /// Steps come in order.
  void add(const SequenceStep& step);
  void print_totals(const Options& options, const Statistics& statistics, const StartCheck& start);
  /// Is every step free that was added?
  bool is_free() const { return free_steps_ == steps_asked_; }

 private:
  std::string part_of(int part) const;
  void print_row(const SequenceStep& step) const;

  std::vector<std::filesystem::path> frames_;
  int substeps_;
  bool json_;
  int width_ = 5;
  Tally total_;
  std::size_t steps_asked_ = 0, free_steps_ = 0;
  double seconds_ = 0;
  Json steps_ = Json::array();
};

}  // namespace tamis::cli
