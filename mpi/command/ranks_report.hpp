// What the ranks did, for people and as JSON.
#pragma once
#include "cli/report.hpp"
#include "mpi/command/step_parts.hpp"
#include "mpi/src/communicator.hpp"
#include "tamis/distributed.hpp"

namespace tamis::distributed {

class RanksReport {
 public:
  /// Collective: the statistics of all ranks' last question.
  RanksReport(Communicator& communicator, const Detector& detector);

  /// A row a rank, and the balance.
  void print() const;
  /// Adds ranks and balance.
  void add_to(cli::Json& json) const;

 private:
  std::vector<Statistics> ranks_;
  Balance balance_;
};

/// Collective: of the contacts of all ranks.
cli::Tally tally_of_all(Communicator& communicator, const std::vector<Contact>& contacts);
void print_mesh(const StepParts& parts);
/// Adds seconds, mesh, and the options that decided.
void add_facts(cli::Json& json, const StepParts& parts, const Options& options);

}  // namespace tamis::distributed
