// Statistics of all ranks, for people and as JSON.
#pragma once
#include "command/report.hpp"
#include "distributed/command/step_parts.hpp"
#include "distributed/src/communicator.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

class RanksReport {
 public:
  /// Collective: gathers all ranks' statistics of the last question.
  RanksReport(Communicator& communicator, const Detector& detector);

  /// Prints a row for each rank, and the balance.
  void print() const;
  /// Adds a row for each rank, and the balance.
  void add_to(cli::Json& json) const;

 private:
  std::vector<Statistics> ranks_;
  Balance balance_;
};

/// Collective: the tally of the contacts of all ranks.
cli::Tally tally_of_all(Communicator& communicator, std::span<const Contact> contacts);
void print_mesh(const StepParts& parts);
/// Adds the minimum separation, and the size of the mesh.
void add_facts(cli::Json& json, const StepParts& parts, const Options& options);

}  // namespace tamis::distributed
