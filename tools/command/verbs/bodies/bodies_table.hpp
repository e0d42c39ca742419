// Prints the answers for the steps of bodies: a single step in full; several as a row each, and the first that is not
// free; or one JSON object.
#pragma once
#include <optional>
#include <vector>

#include "command/report.hpp"
#include "command/start_check.hpp"
#include "command/verbs/bodies/moving_bodies.hpp"

namespace tamis::cli {

class BodiesTable {
 public:
  /// `bodies` must live as long.
  BodiesTable(const MovingBodies& bodies, bool json) : bodies_(bodies), json_(json) {}

  void print_head() const;
  /// Prints, in place of print_head(), that the start does not pass. Returns the exit code.
  int refuse(const StartCheck& start) const;
  /// Steps come in order; `statistics` of the last question.
  void add(const std::vector<BodyContact>& contacts, const Statistics& statistics, const Timing& timing);
  void print_totals(const Options& options, const Statistics& statistics, const StartCheck& start, int repeat);
  bool is_free() const { return free_steps_ == steps_asked_; }

 private:
  struct First {
    std::size_t step;
    BodyContact contact;
  };

  bool is_one() const { return bodies_.step_count() == 1; }
  void print_bodies() const;
  void print_row(const Tally& tally, const Timing& timing) const;
  Json step_json(const Tally& tally, const std::optional<BodyContact>& contact, const Statistics& statistics,
                 const Timing& timing) const;
  Json totals_json(const Options& options, const Statistics& statistics, const StartCheck& start);

  const MovingBodies& bodies_;
  bool json_;
  Tally total_;
  std::size_t steps_asked_ = 0, free_steps_ = 0;
  std::optional<First> first_;
  std::optional<std::size_t> first_not_free_;  ///< a step with a contact, or of which a body was left out
  Timing timing_;
  Json steps_ = Json::array();
};

}  // namespace tamis::cli
